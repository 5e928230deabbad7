// A rotation matrix with the conventions of KDL: its angles, axes and quaternions.
#pragma once

#include <array>
#include <cstddef>

#include "tf2/transform.hpp"

namespace tfloom::kdl {

using tf2::Quaternion;
using tf2::Vector3;
using Angles = std::array<double, 3>;

inline constexpr double epsilon = 1e-6;  // of comparisons and lengths, unless a caller gives another

constexpr double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

[[nodiscard]] bool equal(double a, double b, double eps);
[[nodiscard]] bool equal(const Vector3& a, const Vector3& b, double eps);

// The length; 0 if no component reaches eps.
[[nodiscard]] double norm(const Vector3& v, double eps);
// Divide by the length, and return it. A vector shorter than eps becomes x, and 0 is returned.
double normalize(Vector3& v, double eps);

// Row-major. Any nine numbers can be set, as in KDL; the functions of angles expect a rotation.
struct Rotation {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  [[nodiscard]] static Rotation of_columns(const Vector3& x, const Vector3& y, const Vector3& z);
  [[nodiscard]] static Rotation about_x(double angle);
  [[nodiscard]] static Rotation about_y(double angle);
  [[nodiscard]] static Rotation about_z(double angle);
  // About an axis of unit length, and of any length; one shorter than `epsilon` counts as x.
  [[nodiscard]] static Rotation about_unit(const Vector3& axis, double angle);
  [[nodiscard]] static Rotation about(Vector3 axis, double angle);
  // About the fixed axes x, y and z, in this order: Rz(yaw) Ry(pitch) Rx(roll).
  [[nodiscard]] static Rotation of_rpy(double roll, double pitch, double yaw);
  // Rz(alpha) Ry(beta) Rz(gamma).
  [[nodiscard]] static Rotation of_euler_zyz(double alpha, double beta, double gamma);
  // A quaternion that is not of length one gives a matrix scaled by the square of its length.
  [[nodiscard]] static Rotation of_quaternion(const Quaternion& q);

  [[nodiscard]] Angles rpy() const;
  [[nodiscard]] Angles euler_zyz() const;
  [[nodiscard]] Quaternion quaternion() const;

  [[nodiscard]] Vector3 column(std::size_t j) const { return {m[j], m[3 + j], m[6 + j]}; }
  void set_column(std::size_t j, const Vector3& v);
  [[nodiscard]] Rotation inverse() const { return {{m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}}; }
};

struct AxisAngle {
  Vector3 axis;
  double angle = 0.0;
};

// An angle in [0, π] and an axis of unit length. If the matrix is symmetric within eps, the angle is 0, about z, or π,
// about the axis whose largest component is positive.
[[nodiscard]] AxisAngle axis_angle(const Rotation& r, double eps);
// The axis times the angle.
[[nodiscard]] Vector3 rotation_vector(const Rotation& r);

[[nodiscard]] Rotation operator*(const Rotation& a, const Rotation& b);
[[nodiscard]] Vector3 operator*(const Rotation& r, const Vector3& v);
[[nodiscard]] bool equal(const Rotation& a, const Rotation& b, double eps);

}  // namespace tfloom::kdl
