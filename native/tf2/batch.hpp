// Lookups at many stamps at once: the transforms of one chain at each stamp, and points moved by them.
#pragma once

#include <array>
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

// Fill out[i] with target_from_source at stamps[i], and known[i] with whether there is one; where there is none, out[i]
// is unchanged. Stamps may be in any order. Ascending ones are fastest; others are looked up in nearly ascending order.
// If `is_strict`, return the first failure; the transforms after it may then be missing. The buffer's lock is acquired
// again for each few hundred stamps, so an insert may happen in between. `workers` threads share the stamps.
std::optional<FailedStamp> lookup_many(const Buffer& buffer, std::string_view target, std::string_view source,
                                       std::span<const Stamp> stamps, std::span<Transform> out,
                                       std::span<std::uint8_t> known, bool is_strict, unsigned workers);

// Points are rows of x, y, z. `in` and `out` may be the same memory.
template <class T>
void move_points(const Transform& transform, const T* in, T* out, std::size_t count);

// Where the coordinates of a cloud's points are: point (row, column) begins at row * row_step + column * point_step.
struct CloudLayout {
  std::size_t height = 0, width = 0, row_step = 0, point_step = 0;  // the steps in bytes
  std::array<std::size_t, 3> offsets{};  // of x, y and z in a point [bytes]; they may be unaligned

  // Return whether all coordinates of `coordinate_size` bytes lie within `size` bytes.
  [[nodiscard]] bool fits(std::size_t size, std::size_t coordinate_size) const;
};

// Move the points of a cloud in place, as `move_points` does. The layout must fit the data.
template <class T>
void move_cloud(const Transform& transform, const CloudLayout& layout, std::byte* data);

// Move point i from `source` at stamps[i] to `fixed`, then by target_from_fixed. Return the first failure; the contents
// of `out` are then undefined. `workers` threads share the points.
template <class T>
std::optional<FailedStamp> deskew(const Buffer& buffer, std::string_view fixed, std::string_view source,
                                  const Transform& target_from_fixed, std::span<const Stamp> stamps, const T* in,
                                  T* out, unsigned workers);

}  // namespace tfloom::tf2
