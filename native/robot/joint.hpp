// The joints of a robot, and the transform of each at given positions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "tf2/transform.hpp"

namespace tfloom::robot {

enum class JointKind : unsigned char { fixed, revolute, prismatic, planar, floating };

// Number of position variables of a joint: an angle; a distance; x, y and an angle; translation and quaternion.
constexpr std::size_t variable_count(JointKind kind) {
  constexpr std::array<std::size_t, 5> counts{0, 1, 1, 3, 7};
  return counts[static_cast<std::size_t>(kind)];
}

// Return the smallest rotation that turns the z axis to a unit vector.
inline tf2::Quaternion rotation_from_z(const tf2::Vector3& to) {
  if (to.z < -1.0 + 1e-12) return {1.0, 0.0, 0.0, 0.0};  // half a turn about x
  return tf2::canonical({-to.y, to.x, 0.0, 1.0 + to.z});
}

// A joint: where it stands in its parent link, and how it moves. `axis` is a unit vector, in the joint's frame.
struct Joint {
  JointKind kind = JointKind::fixed;
  tf2::Transform origin;
  tf2::Vector3 axis{1.0, 0.0, 0.0};

  // Return parent_from_child. `at` has variable_count(kind) numbers.
  [[nodiscard]] tf2::Transform pose(std::span<const double> at) const {
    switch (kind) {
      case JointKind::revolute:
        return turned({}, about_axis(at[0]));
      case JointKind::prismatic:
        return {rotate(origin.rotation, at[0] * axis) + origin.translation, origin.rotation};
      case JointKind::planar:
        return turned(rotate(rotation_from_z(axis), {at[0], at[1], 0.0}), about_axis(at[2]));
      case JointKind::floating:
        return turned({at[0], at[1], at[2]}, tf2::canonical({at[3], at[4], at[5], at[6]}));
      default:
        return origin;
    }
  }

 private:
  [[nodiscard]] tf2::Quaternion about_axis(double angle) const {
    const double s = std::sin(angle / 2), c = std::cos(angle / 2);
    return {s * axis.x, s * axis.y, s * axis.z, c};
  }
  [[nodiscard]] tf2::Transform turned(const tf2::Vector3& moved, const tf2::Quaternion& rotation) const {
    return {rotate(origin.rotation, moved) + origin.translation, tf2::canonical(origin.rotation * rotation)};
  }
};

}  // namespace tfloom::robot
