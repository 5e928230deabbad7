// The functions of ColumnArithmetic for one width of vectors. columns.cpp includes this file once for each, in another
// namespace, which defines `Lanes`, the numbers of `lane_count` rows, and `lanes_of`, which builds them; and it defines
// TFLOOM_TARGET, the attribute that selects the processor. So there is no `#pragma once`.

inline TFLOOM_TARGET Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline TFLOOM_TARGET void store(const Lanes& lanes, double* to) { std::memcpy(to, &lanes, sizeof lanes); }

TFLOOM_TARGET void compose(const Columns& left, Columns& right, std::size_t count) {
  TFLOOM_INDEPENDENT
  for (std::size_t i = 0; i < count; ++i) right.set(i, left[i] * right[i]);
}

TFLOOM_TARGET void compose_fixed(const Transform& left, Columns& right, std::size_t count) {
  const Transform value = left;
  TFLOOM_INDEPENDENT
  for (std::size_t i = 0; i < count; ++i) right.set(i, value * right[i]);
}

TFLOOM_TARGET void compose_inverse(const Columns& left, Columns& right, std::size_t count) {
  TFLOOM_INDEPENDENT
  for (std::size_t i = 0; i < count; ++i) right.set(i, inverse(left[i]) * right[i]);
}

TFLOOM_TARGET void interpolate(const Vector3& from, const Vector3& to, const NearSlerp& near_slerp,
                               const double* ratios, std::size_t count, std::size_t begin, Columns& out) {
  const NearSlerp rotation = near_slerp;  // a copy, because `out` might overlap the argument
  const Vector3 start = from, difference = to - from;
  const std::size_t rounded = (count + Columns::lanes - 1) / Columns::lanes * Columns::lanes;
  TFLOOM_INDEPENDENT
  for (std::size_t i = 0; i < rounded; ++i) {
    const double ratio = ratios[i];
    out.set(begin + i, {start + ratio * difference, rotation.at(ratio)});
  }
}

struct LaneQuaternion {
  Lanes x, y, z, w;
};

inline TFLOOM_TARGET LaneQuaternion rotations(const Transform* const* rows) {
  return {lanes_of(rows, &Transform::rotation, &Quaternion::x), lanes_of(rows, &Transform::rotation, &Quaternion::y),
          lanes_of(rows, &Transform::rotation, &Quaternion::z), lanes_of(rows, &Transform::rotation, &Quaternion::w)};
}

inline TFLOOM_TARGET Lanes between(const Transform* const* older, const Transform* const* newer,
                                   double Vector3::*axis, const Lanes& ratio) {
  const Lanes from = lanes_of(older, &Transform::translation, axis);
  const Lanes to = lanes_of(newer, &Transform::translation, axis);
  return from + ratio * (to - from);
}

// As slerp_series, with c = cos θ - 1.
template <std::size_t Terms>
inline TFLOOM_TARGET Lanes slerp_weights(const Lanes& r, const Lanes& c) {
  const Lanes rr = r * r;
  Lanes sum = 1.0 + (slerp_terms.u[Terms] * rr - slerp_terms.v[Terms]) * c;
  for (std::size_t i = Terms - 1; i > 0; --i) sum = 1.0 + (slerp_terms.u[i] * rr - slerp_terms.v[i]) * c * sum;
  return r * sum;
}

// Interpolate with that many terms of the series, and return the greatest 1 - cos θ.
template <std::size_t Terms>
inline TFLOOM_TARGET double interpolate_by_series(const Pairs& pairs, std::size_t begin, std::size_t end,
                                                  Columns& out) {
  Lanes least{};  // of cos θ - 1
  for (std::size_t i = begin; i < end; i += lane_count) {
    const Transform *const *older = &pairs.older[i], *const *newer = &pairs.newer[i];
    const Lanes ratio = load(&pairs.elapsed[i]) / load(&pairs.distance[i]);
    const LaneQuaternion a = rotations(older), b = rotations(newer);
    const Lanes product = (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
    const Lanes c = (product < 0.0 ? -product : product) - 1.0;
    least = c < least ? c : least;
    const Lanes weight = slerp_weights<Terms>(ratio, c);
    const Lanes wa = slerp_weights<Terms>(1.0 - ratio, c), wb = product < 0.0 ? -weight : weight;
    store(wa * a.x + wb * b.x, &out.qx[i]);
    store(wa * a.y + wb * b.y, &out.qy[i]);
    store(wa * a.z + wb * b.z, &out.qz[i]);
    store(wa * a.w + wb * b.w, &out.qw[i]);
    store(between(older, newer, &Vector3::x, ratio), &out.x[i]);
    store(between(older, newer, &Vector3::y, ratio), &out.y[i]);
    store(between(older, newer, &Vector3::z, ratio), &out.z[i]);
  }
  std::array<double, lane_count> lanes;
  std::memcpy(lanes.data(), &least, sizeof least);
  return -*std::ranges::min_element(lanes);
}

TFLOOM_TARGET void interpolate_pairs(const Pairs& pairs, std::size_t begin, std::size_t end, Columns& out) {
  if (interpolate_by_series<2>(pairs, begin, end, out) < NearSlerp::farthest) return;
  if (interpolate_by_series<8>(pairs, begin, end, out) < slerp_series_farthest) return;
  for (std::size_t i = begin; i < end; ++i) {
    const Transform &a = *pairs.older[i], &b = *pairs.newer[i];
    if (1.0 - std::abs(dot(a.rotation, b.rotation)) < slerp_series_farthest) continue;
    out.set(i, tf2::interpolate(a, b, pairs.elapsed[i] / pairs.distance[i]));
  }
}

constexpr ColumnArithmetic arithmetic{&compose, &compose_fixed, &compose_inverse, &interpolate, &interpolate_pairs};
