#include "tf2/walk.hpp"

#include <algorithm>
#include <vector>

namespace tfloom::tf2 {
namespace {

struct Link {
  Stamp newest = 0;
  FrameId parent = no_parent;
};

Link newest_link(const Frame& frame) {
  if (frame.kind != Frame::Kind::moving) return {0, frame.fixed_parent};
  return {frame.history->newest_stamp(), frame.history->newest_parent()};
}

// Stamps of zero don't count: static frames have them.
Stamp earlier(Stamp common, Stamp newest) { return newest == 0 ? common : std::min(common, newest); }
Stamp settled(Stamp common) { return common == INT64_MAX ? 0 : common; }

}  // namespace

CommonTime latest_common_time(const FrameTable& frames, FrameId target, FrameId source) {
  using Kind = Failure::Kind;
  if (target == no_parent || source == no_parent) return {{Kind::unconnected, {}, no_parent, 0}, 0};
  if (target == source) return {{}, frames[source].newest_stamp()};

  thread_local std::vector<Link> links;  // from the source up; keeps its memory from call to call
  links.clear();
  Stamp common = INT64_MAX;
  FrameId frame = source;
  for (int depth = 0;; ++depth) {
    const Link link = newest_link(frames[frame]);
    if (link.parent == no_parent) break;
    if (depth >= longest_chain) return {{Kind::cycle, {}, frame, 0}, 0};
    links.push_back(link);
    common = earlier(common, link.newest);
    frame = link.parent;
    if (frame == target) return {{}, settled(common)};
  }

  common = INT64_MAX;
  frame = target;
  for (int depth = 0;; ++depth) {
    const Link link = newest_link(frames[frame]);
    if (link.parent == no_parent) break;
    if (depth >= longest_chain) return {{Kind::cycle, {}, frame, 0}, 0};
    common = earlier(common, link.newest);
    frame = link.parent;
    if (frame == source) return {{}, settled(common)};
    const auto meeting = std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.parent == frame; });
    if (meeting != links.end()) {
      for (auto below = links.begin(); below <= meeting; ++below) common = earlier(common, below->newest);
      return {{}, settled(common)};
    }
  }
  return {{Kind::unconnected, {}, no_parent, 0}, 0};
}

}  // namespace tfloom::tf2
