#include "tf2/edge_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tfloom::tf2 {
namespace {

constexpr double s_per_ns = 1e-9;

bool is_finite(const Transform& transform) {
  const auto& [p, q] = transform;
  // A sum is not finite if a part of it isn't; finite parts whose sum overflows count as not finite, too.
  return std::isfinite(p.x + p.y + p.z + q.x + q.y + q.z + q.w);
}

double in_seconds(Stamp ns) { return s_per_ns * static_cast<double>(ns); }

}  // namespace

void EdgeStatistics::add(Stamp stamp, const Transform& transform, Stamp received, Stamp now, bool is_static,
                         Stamp newest_of_child, Stamp cache_time) {
  add_times(stamp, received, now, is_static, newest_of_child, cache_time);
  if (is_finite(transform)) {
    add_value(stamp, transform, is_static);
  } else {
    ++non_finite;
  }
}

void EdgeStatistics::add_times(Stamp stamp, Stamp received, Stamp now, bool is_static, Stamp newest_of_child,
                               Stamp cache_time) {
  if (stamp == 0) {
    ++zero_stamps;
  } else if (now != 0) {
    delay.add(in_seconds(now - stamp));
    if (stamp > now) ++ahead;
  }
  if (count == 0) {
    first_stamp = oldest_stamp = newest_stamp = stamp;
    first_received = received;
  } else {
    receipt_period.add(in_seconds(received - last_received));
    if (stamp > newest_stamp) {
      stamp_period.add(in_seconds(stamp - newest_stamp));
    } else if (stamp == newest_stamp) {
      if (!is_static) ++repeated;
    } else {
      ++out_of_order;
      largest_step_back = std::max(largest_step_back, newest_stamp - stamp);
    }
    if (stamp < last_stamp) ++steps_back;
    oldest_stamp = std::min(oldest_stamp, stamp);
    newest_stamp = std::max(newest_stamp, stamp);
  }
  if (!is_static && newest_of_child - stamp > cache_time) ++too_old;
  last_stamp = stamp;
  last_received = received;
  ++count;
}

void EdgeStatistics::add_value(Stamp stamp, const Transform& transform, bool is_static) {
  const double norm = std::sqrt(dot(transform.rotation, transform.rotation));
  worst_norm_error = std::max(worst_norm_error, std::abs(norm - 1.0));
  const Stamp elapsed = has_value_ ? stamp - value_stamp_ : 0;
  if (has_value_) {
    const bool is_equal = transform.translation == value.translation && transform.rotation == value.rotation;
    if (!is_equal) ++changes;
    if (is_static || elapsed > 0) add_step(transform, stamp, is_static ? 0 : elapsed);
  }
  if (is_static || !has_value_ || elapsed > 0) {
    value = transform;
    value_stamp_ = stamp;
    has_value_ = true;
  }
}

void EdgeStatistics::add_step(const Transform& to, Stamp stamp, Stamp elapsed) {
  const Vector3 moved = to.translation - value.translation;
  Step step{stamp, elapsed, std::sqrt(moved.x * moved.x + moved.y * moved.y + moved.z * moved.z), 0.0};
  distance.add(step.distance);
  const double norms = dot(to.rotation, to.rotation) * dot(value.rotation, value.rotation);
  const double cosine_of_half = norms > 0.0 ? std::min(1.0, std::abs(dot(to.rotation, value.rotation)) / std::sqrt(norms)) : 1.0;
  cosine.add(cosine_of_half);
  const bool is_widest = cosine_of_half < min_cosine_;
  const bool is_longest = step.distance > longest.distance;
  const bool is_fastest = step.speed() > fastest.speed();
  if (!is_widest && !is_longest && !is_fastest) return;
  step.angle_rad = 2.0 * std::acos(cosine_of_half);
  if (is_widest) {
    min_cosine_ = cosine_of_half;
    widest = step;
  }
  if (is_longest) longest = step;
  if (is_fastest) fastest = step;
}

}  // namespace tfloom::tf2
