// Bytes that Python passes as `bytes`.
#pragma once

#include <nanobind/nanobind.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tfloom::bindings {

// Return the bytes of `bytes`; throw ValueError with `rule` if they are not as many.
template <std::size_t size>
std::array<std::uint8_t, size> bytes_of(const nanobind::bytes& bytes, const char* rule) {
  std::array<std::uint8_t, size> result{};
  if (bytes.size() != size) throw nanobind::value_error(rule);
  std::memcpy(result.data(), bytes.data(), size);
  return result;
}

}  // namespace tfloom::bindings
