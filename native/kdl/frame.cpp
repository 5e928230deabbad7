#include "kdl/frame.hpp"

#include <cmath>

namespace tfloom::kdl {

Frame Frame::dh(double a, double alpha, double d, double theta) {
  return {Rotation::about_z(theta) * Rotation::about_x(alpha), {a * std::cos(theta), a * std::sin(theta), d}};
}

Frame Frame::dh_craig(double a, double alpha, double d, double theta) {
  return {Rotation::about_x(alpha) * Rotation::about_z(theta), {a, -std::sin(alpha) * d, std::cos(alpha) * d}};
}

Frame Frame::inverse() const {
  const Rotation back = M.inverse();
  return {back, -(back * p)};
}

void Frame::integrate(const Twist& twist, double frequency) {
  p = p + M * (twist.vel / frequency);
  const double angle = norm(twist.rot, epsilon) / frequency;
  if (angle >= epsilon) M = M * Rotation::about(twist.rot, angle);
}

Vector3 operator*(const Frame& f, const Vector3& v) { return f.M * v + f.p; }
Frame operator*(const Frame& a, const Frame& b) { return {a.M * b.M, a * b.p}; }

bool equal(const Frame& a, const Frame& b, double eps) { return equal(a.p, b.p, eps) && equal(a.M, b.M, eps); }

Vector3 diff(const Rotation& a, const Rotation& b, double dt) {
  return a * (rotation_vector(a.inverse() * b) / dt);
}
Twist diff(const Frame& a, const Frame& b, double dt) { return {diff(a.p, b.p, dt), diff(a.M, b.M, dt)}; }

Rotation add_delta(const Rotation& a, const Vector3& da, double dt) {
  const Vector3 own = a.inverse() * da;
  return a * Rotation::about(own, norm(own, epsilon) * dt);
}
Frame add_delta(const Frame& a, const Twist& da, double dt) {
  return {add_delta(a.M, da.rot, dt), add_delta(a.p, da.vel, dt)};
}

}  // namespace tfloom::kdl
