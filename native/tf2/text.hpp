// Formatting of texts. Numbers are printed as the reference prints them, independent of the program's locale.
#pragma once

#include <locale>
#include <sstream>
#include <string>
#include <string_view>

#include "tf2/errors.hpp"

namespace tfloom::tf2 {

template <class... Parts>
std::string join(const Parts&... parts) {
  std::string text;
  (text.append(std::string_view(parts)), ...);
  return text;
}

inline std::string fixed(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << std::fixed << value;
  return out.str();
}

inline double seconds(Stamp stamp) { return static_cast<double>(stamp) / 1e9; }

inline std::string time_text(Stamp stamp) { return fixed(seconds(stamp), 6); }

}  // namespace tfloom::tf2
