// Transforms as columns of numbers, so that those of several stamps are computed at once, in vector registers.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tf2/transform.hpp"

namespace tfloom::tf2 {

struct Columns {
  static constexpr std::size_t size = 128;
  static constexpr std::size_t lanes = 4;  // rows computed at once, or a multiple of it

  [[nodiscard]] Transform operator[](std::size_t i) const {
    return {{x[i], y[i], z[i]}, {qx[i], qy[i], qz[i], qw[i]}};
  }
  void set(std::size_t i, const Transform& t) {
    x[i] = t.translation.x, y[i] = t.translation.y, z[i] = t.translation.z;
    qx[i] = t.rotation.x, qy[i] = t.rotation.y, qz[i] = t.rotation.z, qw[i] = t.rotation.w;
  }

  using Column = std::array<double, size + lanes>;
  Column x, y, z, qx, qy, qz, qw;  // not initialised, because each row is written before it is read
};

// For each row, two samples of a link, and a time between them as a fraction of their distance.
struct Pairs {
  void set(std::size_t i, const Transform& from, const Transform& to, double elapsed_ns, double distance_ns) {
    older[i] = &from, newer[i] = &to, elapsed[i] = elapsed_ns, distance[i] = distance_ns;
  }

  std::array<const Transform*, Columns::size + Columns::lanes> older, newer;
  Columns::Column elapsed, distance;
};

// The arithmetic on columns. All write whole vectors, so up to `Columns::lanes` - 1 rows after the last are undefined
// afterwards, and `ratios` and `pairs` must have as many valid ones more.
struct ColumnArithmetic {
  // right = left * right, for the first `count` rows.
  void (*compose)(const Columns& left, Columns& right, std::size_t count);
  void (*compose_fixed)(const Transform& left, Columns& right, std::size_t count);
  // right = inverse(left) * right.
  void (*compose_inverse)(const Columns& left, Columns& right, std::size_t count);
  // Write the transforms between two samples at `count` ratios into `out`, from row `begin` on.
  void (*interpolate)(const Vector3& from, const Vector3& to, const NearSlerp& rotation, const double* ratios,
                      std::size_t count, std::size_t begin, Columns& out);
  // Write the transforms between the samples of each pair, for the rows from `begin` to before `end`.
  void (*interpolate_pairs)(const Pairs& pairs, std::size_t begin, std::size_t end, Columns& out);
};

// Return the form for the vectors in use. The forms' results differ in the last digits, because the wide one rounds a
// product and a sum once.
const ColumnArithmetic& column_arithmetic();

}  // namespace tfloom::tf2
