// wstring: UTF-16 code units, each in four bytes on the wire.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cdr/cursor.hpp"

namespace tfloom::cdr {

inline bool is_high_surrogate(std::uint32_t unit) noexcept { return unit >= 0xd800 && unit < 0xdc00; }
inline bool is_low_surrogate(std::uint32_t unit) noexcept { return unit >= 0xdc00 && unit < 0xe000; }

// Read a wstring as code points. Surrogates must be in pairs.
inline std::u32string read_wide(Cursor& in) {
  const auto length = in.read_length(sizeof(std::uint32_t));
  std::u32string text;
  text.reserve(length);
  std::uint32_t high = 0;
  for (std::uint32_t i = 0; i < length; ++i) {
    const std::size_t at = in.offset();
    const auto unit = in.read<std::uint32_t>();
    const bool low = is_low_surrogate(unit);
    if (low != (high != 0) || unit > 0x10ffff) throw DecodeError(at, "the text is not UTF-16");
    if (low) text.push_back(static_cast<char32_t>(0x10000 + ((high - 0xd800) << 10) + (unit - 0xdc00)));
    high = is_high_surrogate(unit) ? unit : 0;
    if (!low && high == 0) text.push_back(static_cast<char32_t>(unit));
  }
  if (high != 0) in.fail("the text is not UTF-16");
  return text;
}

template <class Writer>
void write_wide(Writer& out, std::u32string_view text) {
  std::uint32_t units = 0;
  for (const char32_t letter : text) units += letter > 0xffff ? 2 : 1;
  out.write(units);
  for (const char32_t letter : text) {
    const auto point = static_cast<std::uint32_t>(letter);
    if (point <= 0xffff) {
      out.write(point);
    } else {
      out.write(std::uint32_t{0xd800} + ((point - 0x10000) >> 10));
      out.write(std::uint32_t{0xdc00} + ((point - 0x10000) & 0x3ff));
    }
  }
}

}  // namespace tfloom::cdr
