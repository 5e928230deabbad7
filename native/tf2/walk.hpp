// The walk from two frames up to the frame where their branches meet. Every query uses it. Callers hold the lock of the
// frames.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tf2/frames.hpp"

namespace tfloom::tf2 {

inline constexpr int max_chain_length = 1000;  // links on one side; a longer one counts as a cycle

// Why a walk found no path. Texts are made from it only on request.
struct Failure {
  enum class Kind : std::uint8_t { none, extrapolation, unconnected, cycle };

  Kind kind = Kind::none;
  Bracket::Found reason = Bracket::Found::yes;  // of an extrapolation
  FrameId frame = no_parent;                    // whose history lacks `stamp`
  Stamp stamp = 0;

  explicit operator bool() const { return kind != Kind::none; }
};

// Walk both branches at one time. Call visitor.source(id, bracket) and visitor.target(id, bracket) for each link, from
// the bottom up, and visitor.clear_source() if the source is above the target.
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
      // The branches may meet below this gap. If they do not, it is the reason for the failure.
      gap = {Kind::extrapolation, bracket.found, top, stamp};
      break;
    }
    if (bracket.parent == no_parent) break;  // the transform's parent has the reserved name
    if (depth >= max_chain_length) return {Kind::cycle, {}, top, stamp};
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
      visitor.clear_source();
      return {};
    }
    if (bracket.parent == no_parent) break;
    if (depth >= max_chain_length) return {Kind::cycle, {}, reached, stamp};
    visitor.target(reached, bracket);
    reached = bracket.parent;
  }
  if (reached == top) return {};
  if (gap) return gap;
  return {Kind::unconnected, {}, no_parent, stamp};
}

// The chain between two different frames through each frame's newest parent, and the newest time at which all of it is
// known. The time is zero if all of it is static.
class NewestChain {
 public:
  NewestChain(const FrameTable& frames, FrameId target, FrameId source);

  [[nodiscard]] const Failure& failure() const { return failure_; }
  [[nodiscard]] Stamp stamp() const { return stamp_; }
  // Whether each moving link's newest sample has that stamp. If so, the newest values give the answer.
  [[nodiscard]] bool is_uniform() const { return is_uniform_; }
  // The frames below the one where the branches meet, from the bottom up.
  [[nodiscard]] std::span<const FrameId> source_links() const { return {source_.data(), source_count_}; }
  [[nodiscard]] std::span<const FrameId> target_links() const { return {target_.data(), target_count_}; }

 private:
  using Ids = std::array<FrameId, max_chain_length + 1>;

  void find(const FrameTable& frames, FrameId target, FrameId source);
  void find_meeting_frame(const FrameTable& frames, FrameId top);
  void compute_stamp(const FrameTable& frames);

  Failure failure_;
  Stamp stamp_ = 0;
  bool is_uniform_ = false;
  std::size_t source_count_ = 0, target_count_ = 0;
  Ids source_, target_;  // not initialised: few are used
};

// The stamp of a NewestChain.
struct CommonTime {
  Failure failure;
  Stamp stamp = 0;
};
CommonTime latest_common_time(const FrameTable& frames, FrameId target, FrameId source);

}  // namespace tfloom::tf2
