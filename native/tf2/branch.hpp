// One branch of a chain at the stamps of a chunk: each link's transforms, and their product.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tf2/columns.hpp"
#include "tf2/frames.hpp"

namespace tfloom::tf2 {

// One link of the chain, with the position of the last read in its history.
struct Link {
  const Frame* frame = nullptr;
  FrameId parent = no_parent;
  TimeCache::Position hint{};
};

// Compose one branch for at most `Columns::size` stamps, link by link, so that each history is read once and in order.
// Clear known[i] where a link has no data at stamps[i], or has another parent than the chain; out[i] is then undefined.
// `value` holds one link's transforms.
void compose_branch(std::vector<Link>& links, std::span<const Stamp> stamps, Columns& out, Columns& value,
                    std::span<std::uint8_t> known);

}  // namespace tfloom::tf2
