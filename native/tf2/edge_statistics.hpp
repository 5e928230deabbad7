// What is known of the transforms that one publisher has sent for one edge of the tree.
#pragma once

#include <cmath>
#include <cstdint>

#include "tf2/time_cache.hpp"
#include "tf2/transform.hpp"

namespace tfloom::tf2 {

// Number, mean, deviation and extremes of values, added one by one by Welford's method. All are 0 without a value.
struct Spread {
  std::uint64_t count = 0;
  double mean = 0.0, least = 0.0, greatest = 0.0;
  double squares = 0.0;  // sum of the squared distances from the mean

  void add(double value) {
    if (count == 0) least = greatest = value;
    if (value < least) least = value;
    if (value > greatest) greatest = value;
    ++count;
    const double from_mean = value - mean;
    mean += from_mean / static_cast<double>(count);
    squares += from_mean * (value - mean);
  }

  [[nodiscard]] double deviation() const {  // of the population
    return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count));
  }
};

// The motion between two consecutive transforms, in order of their stamps.
struct Step {
  Stamp stamp = 0;    // of the later one
  Stamp elapsed = 0;  // 0: there was no step yet, or it is static
  double distance = 0.0;   // [m]
  double angle_rad = 0.0;  // 0 to pi

  [[nodiscard]] double speed() const { return elapsed > 0 ? distance / (1e-9 * static_cast<double>(elapsed)) : 0.0; }
};

// Stamps and times of receipt are [ns since epoch], durations in spreads are [s].
struct EdgeStatistics {
  std::uint64_t count = 0;
  Stamp first_stamp = 0, last_stamp = 0;    // in order of receipt
  Stamp oldest_stamp = 0, newest_stamp = 0;
  Stamp first_received = 0, last_received = 0;

  Spread stamp_period;    // between a stamp and the newest before it; steps back and repetitions are not in it
  Spread receipt_period;  // between receipts
  Spread delay;           // from stamp to receipt, without zero stamps; negative: the stamp is ahead of now

  std::uint64_t out_of_order = 0;  // older than the newest one
  std::uint64_t steps_back = 0;    // older than the one received before
  std::uint64_t repeated = 0;      // of the same stamp as the newest one, and moving
  std::uint64_t too_old = 0;       // older than the child's newest by more than the cache time: a buffer rejects them
  std::uint64_t ahead = 0;         // stamps ahead of now
  std::uint64_t zero_stamps = 0;
  Stamp largest_step_back = 0;     // of a stamp, behind the newest [ns]

  std::uint64_t non_finite = 0;   // transforms with a NaN or an infinity, which are in no figure below
  double worst_norm_error = 0.0;  // greatest | |q| - 1 |
  std::uint64_t changes = 0;      // of the value

  Transform value;  // of the newest stamp; of a static edge, the last
  Spread distance;  // of the steps [m]
  Spread cosine;    // of half the angles of the steps, because an arc cosine for each one would take longer
  Step longest, widest, fastest;  // the steps of greatest distance, angle and speed

  // Add a transform. `now` is the time with which the stamp is compared; 0: unknown.
  // `newest_of_child` is the newest stamp of the child from any publisher, before this one; 0: none.
  void add(Stamp stamp, const Transform& transform, Stamp received, Stamp now, bool is_static, Stamp newest_of_child,
           Stamp cache_time);

 private:
  void add_times(Stamp stamp, Stamp received, Stamp now, bool is_static, Stamp newest_of_child, Stamp cache_time);
  void add_value(Stamp stamp, const Transform& transform, bool is_static);
  void add_step(const Transform& to, Stamp stamp, Stamp elapsed);

  bool has_value_ = false;
  Stamp value_stamp_ = 0;
  double min_cosine_ = 1.0;  // of half the angle of `widest`
};

}  // namespace tfloom::tf2
