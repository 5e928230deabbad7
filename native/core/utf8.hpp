// Validation of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace tfloom {

// Return whether `text` is well-formed by table 3-7 of the Unicode standard: no overlong forms, no surrogates, nothing
// beyond U+10FFFF.
inline bool is_utf8(std::string_view text) {
  const auto* at = reinterpret_cast<const unsigned char*>(text.data());
  const auto* const end = at + text.size();
  const auto is_continuation = [&](std::ptrdiff_t index) { return (at[index] & 0xC0U) == 0x80U; };
  while (at < end) {
    const unsigned first = *at;
    if (first < 0x80) {
      ++at;
      continue;
    }
    if (first < 0xC2 || first > 0xF4) return false;
    const std::ptrdiff_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (length > end - at) return false;
    for (std::ptrdiff_t i = 1; i < length; ++i) {
      if (!is_continuation(i)) return false;
    }
    if (first == 0xE0 && at[1] < 0xA0) return false;
    if (first == 0xED && at[1] > 0x9F) return false;
    if (first == 0xF0 && at[1] < 0x90) return false;
    if (first == 0xF4 && at[1] > 0x8F) return false;
    at += length;
  }
  return true;
}

}  // namespace tfloom
