#include "kdl/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tfloom::kdl {
namespace {

// Where the functions of angles take two axes as parallel.
constexpr double parallel = 1e-12;

// The index of the largest of three numbers; of equal ones, the last.
std::size_t largest(double x, double y, double z) {
  if (x > y && x > z) return 0;
  return y > z ? 1 : 2;
}

bool is_symmetric(const Rotation& r, double eps) {
  return std::abs(r.m[1] - r.m[3]) < eps && std::abs(r.m[2] - r.m[6]) < eps && std::abs(r.m[5] - r.m[7]) < eps;
}

// Of a rotation by 0 or π.
AxisAngle axis_angle_of_symmetric(const Rotation& r, double eps) {
  const double xy = r.m[1] + r.m[3], xz = r.m[2] + r.m[6], yz = r.m[5] + r.m[7];
  const bool is_diagonal = std::abs(xy) < eps && std::abs(xz) < eps && std::abs(yz) < eps;
  if (is_diagonal && std::abs(r.m[0] + r.m[4] + r.m[8] - 3.0) < eps) return {{0, 0, 1}, 0.0};
  const Vector3 squares{(r.m[0] + 1) / 2, (r.m[4] + 1) / 2, (r.m[8] + 1) / 2};
  switch (largest(squares.x, squares.y, squares.z)) {
    case 0: {
      const double x = std::sqrt(squares.x);
      return {{x, xy / (4 * x), xz / (4 * x)}, std::numbers::pi};
    }
    case 1: {
      const double y = std::sqrt(squares.y);
      return {{xy / (4 * y), y, yz / (4 * y)}, std::numbers::pi};
    }
    default: {
      const double z = std::sqrt(squares.z);
      return {{xz / (4 * z), yz / (4 * z), z}, std::numbers::pi};
    }
  }
}

}  // namespace

bool equal(double a, double b, double eps) { return std::abs(a - b) < eps; }

bool equal(const Vector3& a, const Vector3& b, double eps) {
  return equal(a.x, b.x, eps) && equal(a.y, b.y, eps) && equal(a.z, b.z, eps);
}

double norm(const Vector3& v, double eps) {
  const double longest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return longest < eps ? 0.0 : std::hypot(v.x, v.y, v.z);
}

double normalize(Vector3& v, double eps) {
  const double length = norm(v, eps);
  if (length < eps || length == 0.0) {
    v = {1, 0, 0};
    return 0.0;
  }
  v = v / length;
  return length;
}

Rotation Rotation::of_columns(const Vector3& x, const Vector3& y, const Vector3& z) {
  return {{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
}

Rotation Rotation::about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{1, 0, 0, 0, c, -s, 0, s, c}};
}

Rotation Rotation::about_y(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, 0, s, 0, 1, 0, -s, 0, c}};
}

Rotation Rotation::about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, -s, 0, s, c, 0, 0, 0, 1}};
}

Rotation Rotation::about_unit(const Vector3& a, double angle) {
  const double c = std::cos(angle), v = 1 - c;
  const Vector3 s = std::sin(angle) * a, t = v * a;
  return {{c + t.x * a.x, t.x * a.y - s.z, t.x * a.z + s.y, t.x * a.y + s.z, c + t.y * a.y, t.y * a.z - s.x,
           t.x * a.z - s.y, t.y * a.z + s.x, c + t.z * a.z}};
}

Rotation Rotation::about(Vector3 axis, double angle) {
  normalize(axis, epsilon);
  return about_unit(axis, angle);
}

// Written out, because the signs of zeros decide between -π and π when the angles are read back.
Rotation Rotation::of_rpy(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch),
               cy = std::cos(yaw), sy = std::sin(yaw);
  return {{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, sy * cp, sy * sp * sr + cy * cr,
           sy * sp * cr - cy * sr, -sp, cp * sr, cp * cr}};
}

Rotation Rotation::of_euler_zyz(double alpha, double beta, double gamma) {
  const double ca = std::cos(alpha), sa = std::sin(alpha), cb = std::cos(beta), sb = std::sin(beta),
               cg = std::cos(gamma), sg = std::sin(gamma);
  return {{ca * cb * cg - sa * sg, -ca * cb * sg - sa * cg, ca * sb, sa * cb * cg + ca * sg, -sa * cb * sg + ca * cg,
           sa * sb, -sb * cg, sb * sg, cb}};
}

Rotation Rotation::of_quaternion(const Quaternion& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z, wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy), 2 * (xy + wz), ww - xx + yy - zz, 2 * (yz - wx),
           2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz}};
}

Angles Rotation::rpy() const {
  const double pitch = std::atan2(-m[6], std::hypot(m[0], m[3]));
  // At ±π/2, roll and yaw turn about the same axis, so roll is set to 0.
  if (std::abs(pitch) > std::numbers::pi / 2 - parallel) return {0.0, pitch, std::atan2(-m[1], m[4])};
  return {std::atan2(m[7], m[8]), pitch, std::atan2(m[3], m[0])};
}

Angles Rotation::euler_zyz() const {
  // At 0 and π, alpha and gamma turn about the same axis, so gamma is set to 0.
  if (m[8] > 1 - parallel) return {std::atan2(m[3], m[0]), 0.0, 0.0};
  if (m[8] < parallel - 1) return {std::atan2(-m[3], -m[0]), std::numbers::pi, 0.0};
  return {std::atan2(m[5], m[2]), std::atan2(std::hypot(m[6], m[7]), m[8]), std::atan2(m[7], -m[6])};
}

Quaternion Rotation::quaternion() const {
  if (m[0] + m[4] + m[8] > parallel) return tf2::upright_quaternion_of_matrix(m);
  return tf2::quaternion_of_matrix(m, largest(m[0], m[4], m[8]));
}

void Rotation::set_column(std::size_t j, const Vector3& v) {
  m[j] = v.x;
  m[3 + j] = v.y;
  m[6 + j] = v.z;
}

AxisAngle axis_angle(const Rotation& r, double eps) {
  if (is_symmetric(r, eps)) return axis_angle_of_symmetric(r, eps);
  Vector3 axis{r.m[7] - r.m[5], r.m[2] - r.m[6], r.m[3] - r.m[1]};
  const double twice_sine = normalize(axis, 0.0), trace = r.m[0] + r.m[4] + r.m[8];
  return {axis, std::atan2(twice_sine / 2, (trace - 1) / 2)};
}

Vector3 rotation_vector(const Rotation& r) {
  const AxisAngle turn = axis_angle(r, epsilon);
  return turn.angle * turn.axis;
}

Rotation operator*(const Rotation& a, const Rotation& b) {
  return Rotation::of_columns(a * b.column(0), a * b.column(1), a * b.column(2));
}

Vector3 operator*(const Rotation& r, const Vector3& v) {
  return {r.m[0] * v.x + r.m[1] * v.y + r.m[2] * v.z, r.m[3] * v.x + r.m[4] * v.y + r.m[5] * v.z,
          r.m[6] * v.x + r.m[7] * v.y + r.m[8] * v.z};
}

bool equal(const Rotation& a, const Rotation& b, double eps) {
  return std::equal(a.m.begin(), a.m.end(), b.m.begin(), [eps](double x, double y) { return equal(x, y, eps); });
}

}  // namespace tfloom::kdl
