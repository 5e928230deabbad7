// The walk from two frames up to where their branches meet: the heart of every query. Callers hold the frames' lock.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tf2/frames.hpp"

namespace tfloom::tf2 {

inline constexpr int longest_chain = 1000;  // links on one side; more is a cycle

// Why a walk found no path; texts are made from it only when somebody asks.
struct Failure {
  enum class Kind : std::uint8_t { none, extrapolation, unconnected, cycle };

  Kind kind = Kind::none;
  Bracket::Found reason = Bracket::Found::yes;  // of an extrapolation
  FrameId frame = no_parent;                    // whose history lacks `stamp`
  Stamp stamp = 0;

  explicit operator bool() const { return kind != Kind::none; }
};

// Walks both branches at one time. visitor.source(id, bracket) and visitor.target(id, bracket) are called for each
// link, from the bottom up; visitor.forget_source() when the source turns out to lie above the target.
template <class Visitor>
Failure walk(const FrameTable& frames, FrameId target, FrameId source, Stamp stamp, Visitor& visitor) {
  using Kind = Failure::Kind;
  Failure gap;
  FrameId top = source;
  for (int depth = 0; top != target; ++depth) {
    const Frame& frame = frames[top];
    if (frame.kind == Frame::Kind::root) break;
    const Bracket bracket = frame.find(stamp);
    if (bracket.found != Bracket::Found::yes) {
      // The branches may meet below this gap; if they don't, it's the reason.
      gap = {Kind::extrapolation, bracket.found, top, stamp};
      break;
    }
    if (depth >= longest_chain) return {Kind::cycle, {}, top, stamp};
    visitor.source(top, bracket);
    top = bracket.parent;
  }
  FrameId reached = target;
  for (int depth = 0; reached != top; ++depth) {
    const Frame& frame = frames[reached];
    if (frame.kind == Frame::Kind::root) break;
    const Bracket bracket = frame.find(stamp);
    if (bracket.found != Bracket::Found::yes) return {Kind::extrapolation, bracket.found, reached, stamp};
    if (reached == source) {
      visitor.forget_source();
      return {};
    }
    if (depth >= longest_chain) return {Kind::cycle, {}, reached, stamp};
    visitor.target(reached, bracket);
    reached = bracket.parent;
  }
  if (reached == top) return {};
  if (gap) return gap;
  return {Kind::unconnected, {}, no_parent, stamp};
}

// The chain between two different frames by each frame's newest parent, and the newest time at which all of it is
// known. Zero: all of it is static.
class NewestChain {
 public:
  NewestChain(const FrameTable& frames, FrameId target, FrameId source);

  [[nodiscard]] const Failure& failure() const { return failure_; }
  [[nodiscard]] Stamp stamp() const { return stamp_; }
  // Whether each moving link's newest sample is of that time: then their newest values are the answer.
  [[nodiscard]] bool is_uniform() const { return is_uniform_; }
  // The frames below the one where the branches meet, from the bottom up.
  [[nodiscard]] std::span<const FrameId> source_links() const { return {source_.data(), source_count_}; }
  [[nodiscard]] std::span<const FrameId> target_links() const { return {target_.data(), target_count_}; }

 private:
  using Ids = std::array<FrameId, longest_chain + 1>;

  void find(const FrameTable& frames, FrameId target, FrameId source);
  void meet_below(const FrameTable& frames, FrameId top);
  void settle(const FrameTable& frames);

  Failure failure_;
  Stamp stamp_ = 0;
  bool is_uniform_ = false;
  std::size_t source_count_ = 0, target_count_ = 0;
  Ids source_, target_;  // not initialised: few are used
};

// Its time alone.
struct CommonTime {
  Failure failure;
  Stamp stamp = 0;
};
CommonTime latest_common_time(const FrameTable& frames, FrameId target, FrameId source);

}  // namespace tfloom::tf2
