// Frames, twists and wrenches of KDL, their change of frame and of reference point, differences and small motions.
#pragma once

#include <concepts>

#include "kdl/rotation.hpp"

namespace tfloom::kdl {

// The velocity of a rigid body: that of the point of reference, and the angular one.
struct Twist {
  Vector3 vel, rot;
};

// Force, and torque about the point of reference.
struct Wrench {
  Vector3 force, torque;
};

// parent_from_child: p_parent = M p_child + p.
struct Frame {
  Rotation M;
  Vector3 p;

  // Denavit and Hartenberg's parameters: x along the axis of the next joint's normal (`dh`), or of this one's as in
  // Craig's "Introduction to Robotics", 1989 (`dh_craig`).
  [[nodiscard]] static Frame dh(double a, double alpha, double d, double theta);
  [[nodiscard]] static Frame dh_craig(double a, double alpha, double d, double theta);

  [[nodiscard]] Frame inverse() const;
  // Move by a twist in this frame's own axes for 1/frequency seconds. A rotation below `epsilon` is left out.
  void integrate(const Twist& twist, double frequency);
};

// Two vectors, the second of which is that of a rotation.
template <typename T>
concept Screw = std::same_as<T, Twist> || std::same_as<T, Wrench>;

template <Screw T>
constexpr T operator+(const T& a, const T& b) {
  const auto& [a1, a2] = a;
  const auto& [b1, b2] = b;
  return {a1 + b1, a2 + b2};
}
template <Screw T>
constexpr T operator-(const T& a, const T& b) {
  const auto& [a1, a2] = a;
  const auto& [b1, b2] = b;
  return {a1 - b1, a2 - b2};
}
template <Screw T>
constexpr T operator-(const T& screw) {
  const auto& [first, second] = screw;
  return {-first, -second};
}
template <Screw T>
constexpr T operator*(double factor, const T& screw) {
  const auto& [first, second] = screw;
  return {factor * first, factor * second};
}
template <Screw T>
constexpr T operator/(const T& screw, double divisor) {
  const auto& [first, second] = screw;
  return {first / divisor, second / divisor};
}

// The power of a wrench along a twist with the same point of reference.
constexpr double dot(const Twist& t, const Wrench& w) { return dot(t.vel, w.force) + dot(t.rot, w.torque); }

// The same motion, or load, with the point of reference moved by `base`, in the same axes.
constexpr Twist ref_point(const Twist& t, const Vector3& base) { return {t.vel + tf2::cross(t.rot, base), t.rot}; }
constexpr Wrench ref_point(const Wrench& w, const Vector3& base) {
  return {w.force, w.torque + tf2::cross(w.force, base)};
}

// Other axes, and the same point of reference.
template <Screw T>
[[nodiscard]] T operator*(const Rotation& r, const T& screw) {
  const auto& [first, second] = screw;
  return {r * first, r * second};
}

// Other axes, and the parent's origin as the point of reference.
[[nodiscard]] Vector3 operator*(const Frame& f, const Vector3& v);
[[nodiscard]] Frame operator*(const Frame& a, const Frame& b);
template <Screw T>
[[nodiscard]] T operator*(const Frame& f, const T& screw) {
  return ref_point(f.M * screw, -f.p);
}

template <Screw T>
[[nodiscard]] bool equal(const T& a, const T& b, double eps) {
  const auto& [a1, a2] = a;
  const auto& [b1, b2] = b;
  return equal(a1, b1, eps) && equal(a2, b2, eps);
}
[[nodiscard]] bool equal(const Frame& a, const Frame& b, double eps);

// The constant velocity that leads from a to b in dt seconds, in the axes that a and b are given in.
[[nodiscard]] Vector3 diff(const Rotation& a, const Rotation& b, double dt);
[[nodiscard]] Twist diff(const Frame& a, const Frame& b, double dt);
template <typename Linear>
[[nodiscard]] Linear diff(const Linear& a, const Linear& b, double dt) {
  return (b - a) / dt;
}

// What a becomes with that velocity in dt seconds.
[[nodiscard]] Rotation add_delta(const Rotation& a, const Vector3& da, double dt);
[[nodiscard]] Frame add_delta(const Frame& a, const Twist& da, double dt);
template <typename Linear>
[[nodiscard]] Linear add_delta(const Linear& a, const Linear& da, double dt) {
  return a + dt * da;
}

}  // namespace tfloom::kdl
