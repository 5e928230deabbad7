#include "tf2/walk.hpp"

#include <algorithm>

namespace tfloom::tf2 {

NewestChain::NewestChain(const FrameTable& frames, FrameId target, FrameId source) { find(frames, target, source); }

void NewestChain::find(const FrameTable& frames, FrameId target, FrameId source) {
  using Kind = Failure::Kind;
  constexpr auto max_links = static_cast<std::size_t>(max_chain_length);
  if (target == no_parent || source == no_parent) {
    failure_ = {Kind::unconnected, {}, no_parent, 0};
    return;
  }
  // From the source up to the root. If the target is on this branch, it is the whole chain. Without a limit, a cycle of
  // newest parents would be followed for ever.
  FrameId top = source;
  for (;;) {
    const FrameId parent = frames.newest(top).parent;
    if (parent == no_parent) break;
    if (source_count_ == max_links) {
      failure_ = {Kind::cycle, {}, top, 0};
      return;
    }
    source_[source_count_++] = top;
    top = parent;
    if (top == target) return compute_stamp(frames);
  }
  // From the target up to the root, or to the source: then the source's branch has no link.
  FrameId reached = target;
  for (;;) {
    const FrameId parent = frames.newest(reached).parent;
    if (parent == no_parent) break;
    if (target_count_ == max_links) return find_meeting_frame(frames, reached);
    target_[target_count_++] = reached;
    reached = parent;
    if (reached == source) {
      source_count_ = 0;
      return compute_stamp(frames);
    }
  }
  if (reached != top) {
    failure_ = {Kind::unconnected, {}, no_parent, 0};
    return;
  }
  // Both branches reach the root, so the links that they share are above the frame where they meet.
  while (source_count_ > 0 && target_count_ > 0 && source_[source_count_ - 1] == target_[target_count_ - 1]) {
    --source_count_;
    --target_count_;
  }
  compute_stamp(frames);
}

// The target's branch is longer than the limit. The branches may still meet below it, and links above the meeting frame
// are not needed. `target_count_` grows until the frame above those links is also on the source's branch, which is then
// cut off there.
void NewestChain::find_meeting_frame(const FrameTable& frames, FrameId top) {
  const std::size_t branch_size = target_count_;
  for (target_count_ = 1; target_count_ <= branch_size; ++target_count_) {
    const FrameId id = target_count_ < branch_size ? target_[target_count_] : top;
    const auto all = source_links();
    const auto meeting = std::ranges::find(all, id);
    if (meeting == all.end()) continue;
    source_count_ = static_cast<std::size_t>(meeting - all.begin());
    compute_stamp(frames);
    // The common time is known, and is the answer of `latest_common_time`. A lookup at it walks the target's branch up to
    // the limit, and fails there; with `is_uniform_` set, that walk would be skipped.
    is_uniform_ = false;
    return;
  }
  failure_ = {Failure::Kind::cycle, {}, top, 0};
}

void NewestChain::compute_stamp(const FrameTable& frames) {
  // The oldest of the moving links' newest stamps. Static links are known at all times.
  Stamp common = INT64_MAX, first = 0;
  bool has_moving = false;
  is_uniform_ = true;
  for (const auto links : {source_links(), target_links()}) {
    for (const FrameId id : links) {
      const Newest& newest = frames.newest(id);
      if (!newest.moves) continue;
      if (newest.stamp != 0) common = std::min(common, newest.stamp);  // zero is ignored, like a static frame
      if (!has_moving) first = newest.stamp;
      has_moving = true;
      is_uniform_ &= newest.stamp == first;
    }
  }
  stamp_ = common == INT64_MAX ? 0 : common;
}

CommonTime latest_common_time(const FrameTable& frames, FrameId target, FrameId source) {
  if (target == source && target != no_parent) return {{}, frames.newest(source).stamp};
  const NewestChain chain(frames, target, source);
  return {chain.failure(), chain.stamp()};
}

}  // namespace tfloom::tf2
