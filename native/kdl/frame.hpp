// Frames, twists and wrenches of KDL, their change of frame and of reference point, differences and small motions.
#pragma once

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

constexpr Twist operator+(const Twist& a, const Twist& b) { return {a.vel + b.vel, a.rot + b.rot}; }
constexpr Twist operator-(const Twist& a, const Twist& b) { return {a.vel - b.vel, a.rot - b.rot}; }
constexpr Twist operator-(const Twist& t) { return {-t.vel, -t.rot}; }
constexpr Twist operator*(double s, const Twist& t) { return {s * t.vel, s * t.rot}; }
constexpr Twist operator/(const Twist& t, double s) { return {t.vel / s, t.rot / s}; }

constexpr Wrench operator+(const Wrench& a, const Wrench& b) { return {a.force + b.force, a.torque + b.torque}; }
constexpr Wrench operator-(const Wrench& a, const Wrench& b) { return {a.force - b.force, a.torque - b.torque}; }
constexpr Wrench operator-(const Wrench& w) { return {-w.force, -w.torque}; }
constexpr Wrench operator*(double s, const Wrench& w) { return {s * w.force, s * w.torque}; }
constexpr Wrench operator/(const Wrench& w, double s) { return {w.force / s, w.torque / s}; }

// The power of a wrench along a twist with the same point of reference.
constexpr double dot(const Twist& t, const Wrench& w) { return dot(t.vel, w.force) + dot(t.rot, w.torque); }

// The same motion, or load, with the point of reference moved by `base`, in the same axes.
constexpr Twist ref_point(const Twist& t, const Vector3& base) { return {t.vel + tf2::cross(t.rot, base), t.rot}; }
constexpr Wrench ref_point(const Wrench& w, const Vector3& base) {
  return {w.force, w.torque + tf2::cross(w.force, base)};
}

// Other axes, and the same point of reference.
[[nodiscard]] Twist operator*(const Rotation& r, const Twist& t);
[[nodiscard]] Wrench operator*(const Rotation& r, const Wrench& w);

// Other axes, and the parent's origin as the point of reference.
[[nodiscard]] Vector3 operator*(const Frame& f, const Vector3& v);
[[nodiscard]] Frame operator*(const Frame& a, const Frame& b);
[[nodiscard]] Twist operator*(const Frame& f, const Twist& t);
[[nodiscard]] Wrench operator*(const Frame& f, const Wrench& w);

[[nodiscard]] bool equal(const Twist& a, const Twist& b, double eps);
[[nodiscard]] bool equal(const Wrench& a, const Wrench& b, double eps);
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
