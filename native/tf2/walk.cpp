#include "tf2/walk.hpp"

#include <algorithm>
#include <vector>

namespace tfloom::tf2 {
namespace {

struct Link {
  Stamp newest = 0;
  FrameId parent = no_parent;
};

// Stamps of zero don't count: static frames have them.
Stamp earlier(Stamp common, Stamp newest) { return newest == 0 ? common : std::min(common, newest); }
Stamp settled(Stamp common) { return common == INT64_MAX ? 0 : common; }

}  // namespace

CommonTime latest_common_time(const FrameTable& frames, FrameId target, FrameId source) {
  using Kind = Failure::Kind;
  if (target == no_parent || source == no_parent) return {{Kind::unconnected, {}, no_parent, 0}, 0};
  if (target == source) return {{}, frames[source].newest_stamp()};

  std::vector<Link> links;  // from the source up
  Stamp common = INT64_MAX;
  FrameId frame = source;
  for (int depth = 0; frames[frame].newest_parent() != no_parent; ++depth) {
    if (depth >= longest_chain) return {{Kind::cycle, {}, frame, 0}, 0};
    links.push_back({frames[frame].newest_stamp(), frames[frame].newest_parent()});
    common = earlier(common, links.back().newest);
    frame = links.back().parent;
    if (frame == target) return {{}, settled(common)};
  }

  common = INT64_MAX;
  frame = target;
  for (int depth = 0; frames[frame].newest_parent() != no_parent; ++depth) {
    if (depth >= longest_chain) return {{Kind::cycle, {}, frame, 0}, 0};
    common = earlier(common, frames[frame].newest_stamp());
    frame = frames[frame].newest_parent();
    if (frame == source) return {{}, settled(common)};
    const auto meeting = std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.parent == frame; });
    if (meeting != links.end()) {
      for (auto link = links.begin(); link <= meeting; ++link) common = earlier(common, link->newest);
      return {{}, settled(common)};
    }
  }
  return {{Kind::unconnected, {}, no_parent, 0}, 0};
}

}  // namespace tfloom::tf2
