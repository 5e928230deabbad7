// A rigid transform as seven doubles, and the arithmetic for a frame tree.
#pragma once

#include <array>
#include <cmath>

namespace tfloom::tf2 {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;

  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vector3 operator-(const Vector3& v) { return {-v.x, -v.y, -v.z}; }
  friend constexpr Vector3 operator*(double s, const Vector3& v) { return {s * v.x, s * v.y, s * v.z}; }
  friend constexpr Vector3 operator/(const Vector3& v, double s) { return {v.x / s, v.y / s, v.z / s}; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;

  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

constexpr double dot(const Quaternion& a, const Quaternion& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
constexpr Quaternion conjugate(const Quaternion& q) { return {-q.x, -q.y, -q.z, q.w}; }
constexpr Quaternion operator-(const Quaternion& q) { return {-q.x, -q.y, -q.z, -q.w}; }

// Hamilton product.
constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

// v + 2w(u × v) + 2u × (u × v), where u is the vector part of a unit quaternion.
constexpr Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const Vector3 u{q.x, q.y, q.z};
  const Vector3 t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}

// Row-major rotation matrix of a quaternion of any length but zero, with the scale 2/‖q‖².
inline std::array<double, 9> rotation_matrix(const Quaternion& q) {
  const double s = 2.0 / dot(q, q);
  const double xs = q.x * s, ys = q.y * s, zs = q.z * s;
  const double wx = q.w * xs, wy = q.w * ys, wz = q.w * zs;
  const double xx = q.x * xs, xy = q.x * ys, xz = q.x * zs;
  const double yy = q.y * ys, yz = q.y * zs, zz = q.z * zs;
  return {1.0 - (yy + zz), xy - wz, xz + wy, xy + wz, 1.0 - (xx + zz), yz - wx, xz - wy, yz + wx, 1.0 - (xx + yy)};
}

// Quaternion of a row-major rotation matrix: the one whose vector component `i` is positive. That component must not be
// near zero.
inline Quaternion quaternion_of_matrix(const std::array<double, 9>& m, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const double root = std::sqrt(m[4 * i] - m[4 * j] - m[4 * k] + 1.0);
  const double s = 0.5 / root;
  std::array<double, 3> v{};
  v[i] = 0.5 * root;
  v[j] = (m[3 * j + i] + m[3 * i + j]) * s;
  v[k] = (m[3 * k + i] + m[3 * i + k]) * s;
  return {v[0], v[1], v[2], (m[3 * k + j] - m[3 * j + k]) * s};
}

// The one with w > 0, of a matrix whose trace is above -1.
inline Quaternion upright_quaternion_of_matrix(const std::array<double, 9>& m) {
  const double root = std::sqrt(m[0] + m[4] + m[8] + 1.0);
  const double s = 0.5 / root;
  return {(m[7] - m[5]) * s, (m[2] - m[6]) * s, (m[3] - m[1]) * s, 0.5 * root};
}

// Of the two solutions, return the one with w > 0 if the trace is positive, else the one whose largest vector component
// is positive. So rotations print with the same signs as in ROS.
inline Quaternion quaternion_of_matrix(const std::array<double, 9>& m) {
  if (m[0] + m[4] + m[8] > 0.0) return upright_quaternion_of_matrix(m);
  return quaternion_of_matrix(m, m[0] < m[4] ? (m[4] < m[8] ? 2 : 1) : (m[0] < m[8] ? 2 : 0));
}

// Unit length and canonical sign. The zero quaternion gives NaN.
inline Quaternion canonical(const Quaternion& q) {
  const double n = dot(q, q);
  if (std::abs(n - 1.0) < 5e-9) {
    // With the way through the matrix alone, `set` takes 12 % longer: benchmarks/native, "canonical".
    const double s = 1.5 - 0.5 * n;  // 1/√n by its series, with an error of 1e-17
    const auto with_sign_of = [&](double leading) {
      const double r = std::copysign(s, leading);
      return Quaternion{r * q.x, r * q.y, r * q.z, r * q.w};
    };
    // The matrix's trace is 4w² - 1, and its diagonal elements are ordered like the squares of x, y, z. If these differ
    // by more than the margin, the matrix would only decide which number is positive.
    constexpr double margin = 1e-6;
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
    if (ww > 0.25 + margin) return with_sign_of(q.w);
    if (ww < 0.25 - margin) {
      if (xx > yy + margin && xx > zz + margin) return with_sign_of(q.x);
      if (yy > xx + margin && yy > zz + margin) return with_sign_of(q.y);
      if (zz > xx + margin && zz > yy + margin) return with_sign_of(q.z);
    }
  }
  return quaternion_of_matrix(rotation_matrix(q));
}

// Weights of the two ends of a slerp: sin((1-r)θ)/sin θ and sin(rθ)/sin θ.
struct SlerpWeights {
  double first, second;
};

// Coefficients of the series of sin(rθ)/sin θ in c = cos θ - 1, for small angles (D. Eberly, "A Fast and Accurate
// Algorithm for Computing SLERP", 2011). It needs no trigonometry, and is exact where acos loses half of the digits.
// With trigonometry, a lookup between samples takes 46 % longer: benchmarks/native, "slerp series".
struct SlerpSeries {
  static constexpr int longest = 8;
  std::array<double, longest + 1> u{}, v{};

  constexpr SlerpSeries() {
    for (int i = 1; i <= longest; ++i) {
      u[static_cast<std::size_t>(i)] = 1.0 / (i * (2 * i + 1));
      v[static_cast<std::size_t>(i)] = static_cast<double>(i) / (2 * i + 1);
    }
  }
};
inline constexpr SlerpSeries slerp_terms;

template <int Terms>
constexpr double slerp_series(double r, double c) {
  const double rr = r * r;
  double sum = 1.0;
  for (std::size_t i = Terms; i > 0; --i) sum = 1.0 + (slerp_terms.u[i] * rr - slerp_terms.v[i]) * c * sum;
  return r * sum;
}

template <int Terms>
constexpr SlerpWeights slerp_by_series(double r, double one_minus_cos) {
  return {slerp_series<Terms>(1.0 - r, -one_minus_cos), slerp_series<Terms>(r, -one_minus_cos)};
}

inline constexpr double slerp_series_farthest = 0.02;  // 1 - cos θ, for θ < 11.5°

inline SlerpWeights slerp_weights(double r, double one_minus_cos) {
  // With these numbers of terms, the remainder is below 1e-16.
  if (one_minus_cos < 1e-4) return slerp_by_series<4>(r, one_minus_cos);  // θ < 0.8°
  if (one_minus_cos < slerp_series_farthest) return slerp_by_series<8>(r, one_minus_cos);
  const double c = 1.0 - one_minus_cos;
  const double sine = std::sqrt(one_minus_cos * (1.0 + c));
  const double angle = std::atan2(sine, c);
  return {std::sin((1.0 - r) * angle) / sine, std::sin(r * angle) / sine};
}

// The rotations at many ratios between the same two rotations. For small angles, the weights are polynomials in r.
// Without it, lookup_many and deskew take 20 to 30 % longer: benchmarks/native, "near slerp".
class NearSlerp {
 public:
  static constexpr double farthest = 1e-5;  // 1 - cos θ, for a remainder below 1e-16 with two terms of the series

  NearSlerp(const Quaternion& a, const Quaternion& b_any_sign)
      : a_(a), b_(dot(a, b_any_sign) < 0.0 ? -b_any_sign : b_any_sign) {
    const Quaternion d{b_.x - a_.x, b_.y - a_.y, b_.z - a_.z, b_.w - a_.w};
    const double one_minus_cos = 0.5 * dot(d, d);
    is_near_ = one_minus_cos < farthest;
    for (std::size_t i = 0; i < u_.size(); ++i) {
      u_[i] = -slerp_terms.u[i + 1] * one_minus_cos;
      v_[i] = -slerp_terms.v[i + 1] * one_minus_cos;
    }
  }

  [[nodiscard]] bool is_near() const { return is_near_; }
  [[nodiscard]] Quaternion at(double r) const {
    const double wa = weight(1.0 - r), wb = weight(r);
    return {wa * a_.x + wb * b_.x, wa * a_.y + wb * b_.y, wa * a_.z + wb * b_.z, wa * a_.w + wb * b_.w};
  }

 private:
  [[nodiscard]] double weight(double r) const {
    const double rr = r * r;
    double sum = 1.0;
    for (std::size_t i = u_.size(); i-- > 0;) sum = 1.0 + (u_[i] * rr - v_[i]) * sum;
    return r * sum;
  }

  Quaternion a_, b_;
  std::array<double, 2> u_{}, v_{};
  bool is_near_ = false;
};

// Spherical interpolation of unit quaternions on the shorter arc, r from 0 to 1.
inline Quaternion slerp(const Quaternion& a, const Quaternion& b_any_sign, double r) {
  const Quaternion b = dot(a, b_any_sign) < 0.0 ? -b_any_sign : b_any_sign;
  const Quaternion d{b.x - a.x, b.y - a.y, b.z - a.z, b.w - a.w};
  const auto [wa, wb] = slerp_weights(r, 0.5 * dot(d, d));  // |a - b|² = 2 - 2 cos θ
  return {wa * a.x + wb * b.x, wa * a.y + wb * b.y, wa * a.z + wb * b.z, wa * a.w + wb * b.w};
}

// parent_from_child: p_parent = rotation · p_child + translation.
struct Transform {
  Vector3 translation;
  Quaternion rotation;

  friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

constexpr Transform operator*(const Transform& a, const Transform& b) {
  return {rotate(a.rotation, b.translation) + a.translation, a.rotation * b.rotation};
}

constexpr Transform inverse(const Transform& t) {
  const Quaternion back = conjugate(t.rotation);
  return {-1.0 * rotate(back, t.translation), back};
}

inline Transform interpolate(const Transform& a, const Transform& b, double r) {
  return {a.translation + r * (b.translation - a.translation), slerp(a.rotation, b.rotation, r)};
}

}  // namespace tfloom::tf2
