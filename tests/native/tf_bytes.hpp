// A sound TFMessage in CDR, byte by byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using Bytes = std::vector<std::byte>;

template <class T>
void append(Bytes& bytes, T value) {
  while ((bytes.size() - 4) % sizeof(T) != 0) bytes.push_back(std::byte{0});
  const auto* of_value = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), of_value, of_value + sizeof(T));
}

inline void append(Bytes& bytes, const std::string& text) {
  append(bytes, static_cast<std::uint32_t>(text.size() + 1));
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  bytes.push_back(std::byte{0});
}

// The bytes of a chain of `count` transforms from `frame0` on.
inline Bytes tf_bytes(std::int32_t sec, int count) {
  Bytes bytes{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
  append(bytes, static_cast<std::uint32_t>(count));
  for (int i = 0; i < count; ++i) {
    append(bytes, sec);
    append(bytes, std::uint32_t{0});
    append(bytes, "frame" + std::to_string(i));
    append(bytes, "frame" + std::to_string(i + 1));
    for (int n = 0; n < 6; ++n) append(bytes, 0.5);
    append(bytes, 1.0);
  }
  return bytes;
}
