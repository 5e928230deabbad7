// Many stamps at once: the transforms of one chain at each of them, and points moved by them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "tf2/buffer.hpp"

namespace tfloom::tf2 {

// The stamp that could not be answered, and why.
struct FailedStamp {
  std::size_t index = 0;
  Error error;
};

// Fills out[i] with target_from_source at stamps[i], in any order of stamps, and known[i] with whether there is one;
// out[i] is left alone where there is none. Ascending stamps are fastest; others are looked up in a near enough order.
// Returns the first failure if `is_strict`, and then what comes after it may be missing. Each few hundred stamps take
// the buffer's lock anew, so a result may span an insert. `workers` threads share the stamps.
std::optional<FailedStamp> lookup_many(const Buffer& buffer, std::string_view target, std::string_view source,
                                       std::span<const Stamp> stamps, std::span<Transform> out,
                                       std::span<std::uint8_t> known, bool is_strict, unsigned workers);

// Points are rows of x, y, z. `in` and `out` may be the same memory.
template <class T>
void move_points(const Transform& transform, const T* in, T* out, std::size_t count);

// Moves point i from `source` at stamps[i] to `fixed`, and on by target_from_fixed. Returns the first failure; what is
// in `out` is then of no use. `workers` threads share the points.
template <class T>
std::optional<FailedStamp> deskew(const Buffer& buffer, std::string_view fixed, std::string_view source,
                                  const Transform& target_from_fixed, std::span<const Stamp> stamps, const T* in,
                                  T* out, unsigned workers);

}  // namespace tfloom::tf2
