// The transforms of a TFMessage: one walk for each form in which messages are serialized.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "cdr/cursor.hpp"
#include "core/utf8.hpp"
#include "tf2/buffer.hpp"

namespace tfloom::cdr {

inline constexpr std::int64_t ns_per_s = 1'000'000'000;

// Read a builtin_interfaces/msg/Time.
inline tf2::Stamp read_stamp(Cursor& in) {
  const auto sec = in.read<std::int32_t>();
  const auto nanosec = in.read<std::uint32_t>();
  return sec * ns_per_s + nanosec;
}

// Read a frame id. One that is not UTF-8 is an error, because a Python str cannot hold it.
template <class In>
std::string_view read_frame_id(In& in, std::string_view field) {
  try {
    const std::string_view name = in.read_string();
    if (!is_utf8(name)) in.fail("the text is not UTF-8");
    return name;
  } catch (DecodeError& error) {
    error.enter_field(field);
    throw;
  }
}

template <class In>
tf2::Entry read_transform(In& in) {
  tf2::Entry entry;
  entry.stamp = read_stamp(in);
  entry.frame_id = read_frame_id(in, "header.frame_id");
  entry.child_frame_id = read_frame_id(in, "child_frame_id");
  double numbers[7];
  in.read_into(std::span<double>(numbers));
  const auto& [x, y, z, qx, qy, qz, qw] = numbers;
  entry.value = {{x, y, z}, {qx, qy, qz, qw}};
  return entry;
}

// Append the transforms that follow in a message, each of `min_size` bytes or more, to `entries`; their names are
// views into the message. Throw DecodeError if the bytes are none.
//
// `In` is a cursor of one form, as Cursor. For each, there is a function `read_stamp(In&)`, which reads a header up to
// its frame id.
template <class In>
void read_transforms(In& in, std::size_t min_size, std::vector<tf2::Entry>& entries) {
  const std::uint32_t count = in.read_length(min_size);
  entries.reserve(entries.size() + count);
  for (std::uint32_t i = 0; i < count; ++i) {
    try {
      entries.push_back(read_transform(in));
    } catch (DecodeError& error) {
      error.enter_element(i);
      error.enter_field("transforms");
      throw;
    }
  }
}

}  // namespace tfloom::cdr
