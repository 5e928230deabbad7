// Memory that shows where a library has written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace tfloom::dds {

// Memory for `count` values that a library fills, between bytes that it must leave alone. All bytes start as `canary`.
template <typename T, std::size_t count = 1>
class Canaried {
 public:
  Canaried() { std::memset(memory_, canary, sizeof(memory_)); }

  T* data() { return reinterpret_cast<T*>(memory_ + margin); }

  // Return a value, whichever bytes it has.
  T operator[](std::size_t index) const {
    T value;
    std::memcpy(&value, memory_ + margin + index * sizeof(T), sizeof(T));
    return value;
  }

  // Return whether all bytes but those of the first `filled` values are as they were.
  [[nodiscard]] bool is_intact_beyond(std::size_t filled = count) const {
    const auto is_canary = [](unsigned char octet) { return octet == canary; };
    return std::all_of(memory_, memory_ + margin, is_canary) &&
           std::all_of(memory_ + margin + filled * sizeof(T), memory_ + sizeof(memory_), is_canary);
  }

 private:
  static constexpr unsigned char canary = 0xa5;
  static constexpr std::size_t margin = 256;

  alignas(16) unsigned char memory_[margin + count * sizeof(T) + margin];
};

}  // namespace tfloom::dds
