#include "tf2/time_cache.hpp"

#include "core/prefetch.hpp"

#include <algorithm>

namespace tfloom::tf2 {

void TimeCache::Block::insert(std::size_t index, const Sample& sample) {
  stamps.insert(index, sample.stamp);
  parents.insert(index, sample.parent);
  values.insert(index, sample.value);
}

void TimeCache::Block::reserve() {
  stamps.reserve(block_size);
  parents.reserve(block_size);
  values.reserve(block_size);
}

void TimeCache::Block::drop_pruned() {
  stamps.erase_before(begin);
  parents.erase_before(begin);
  values.erase_before(begin);
  begin = 0;
}

TimeCache::Block TimeCache::Block::split() {
  const std::size_t middle = stamps.size() / 2;
  return {stamps.take_from(middle, block_size), parents.take_from(middle, block_size),
          values.take_from(middle, block_size), 0};
}

bool TimeCache::insert(const Sample& sample) {
  // Prune with the newest stamp before this sample, as the header says.
  const Stamp newest = newest_stamp();
  prune(newest);
  if (!empty() && is_older_than(sample.stamp, max_age_, newest)) return false;
  Position position = first_after(sample.stamp);
  if (contains(sample, position)) return true;
  if (blocks_.empty() || (position.block == blocks_.size() - 1 && position.index == block_size)) {
    blocks_.emplace_back();  // appending starts a new block, so that the blocks before stay full
    // The first block grows with its samples; each further one has room for all of them at once.
    if (blocks_.size() > 1) blocks_.back().reserve();
    position = {blocks_.size() - 1, 0};
  } else if (blocks_[position.block].stamps.size() == block_size) {
    // The sample goes into the middle of a full block. Pruned samples at the block's begin leave room for it; otherwise
    // two halves replace the block, and the sample goes into the one where its place is now.
    Block& full = blocks_[position.block];
    if (full.begin > 0) {
      position.index -= full.begin;
      full.drop_pruned();
    } else {
      Block upper = full.split();
      const std::size_t lower_size = full.stamps.size();
      blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(position.block) + 1, std::move(upper));
      if (position.index > lower_size) position = {position.block + 1, position.index - lower_size};
    }
  }
  blocks_[position.block].insert(position.index, sample);
  ++size_;
  refresh_ends();
  return true;
}

void TimeCache::append(std::span<const Stamp> stamps, FrameId parent, std::span<const Transform> values) {
  if (stamps.empty()) return;
  // Each `insert` would prune with the newest stamp before it, so the last one with the last but one of these stamps.
  // The stamps ascend, so that prunes all that the others would, and once is enough.
  const Stamp before_last = stamps.size() > 1 ? stamps[stamps.size() - 2] : newest_stamp();
  for (std::size_t at = 0; at < stamps.size();) {
    if (blocks_.back().stamps.size() == block_size) {
      blocks_.emplace_back();
      blocks_.back().reserve();
    }
    // What the last block has room for, one column after the other: no sample is moved, as all are newer.
    Block& last = blocks_.back();
    const std::size_t count = std::min(block_size - last.stamps.size(), stamps.size() - at);
    last.stamps.append(stamps.subspan(at, count));
    last.parents.append(count, parent);
    last.values.append(values.subspan(at, count));
    at += count;
  }
  size_ += stamps.size();
  prune(before_last);
  refresh_ends();
}

void TimeCache::prefetch_blocks() const {
  if (empty()) return;
  prefetch(&blocks_.front(), sizeof(Block));
  prefetch(&blocks_.back(), sizeof(Block));
}

void TimeCache::prefetch_ends() const {
  if (empty()) return;
  const Block& first = blocks_.front();
  const Block& last = blocks_.back();
  prefetch(first.stamps.begin() + first.begin);
  prefetch(last.stamps.end(), sizeof(Stamp));
  prefetch(last.parents.end(), sizeof(FrameId));
  prefetch(last.values.end(), sizeof(Transform));
}

Bracket TimeCache::find(Stamp stamp) const {
  using Found = Bracket::Found;
  if (empty()) return {};
  const Stamp newest = newest_stamp_;
  if (stamp == latest || stamp == newest) return {Found::yes, newest_parent_, newest_value_, nullptr, 0.0};
  if (size_ == 1) return {Found::only_one, no_parent, nullptr, nullptr, 0.0};
  if (stamp > newest) return {Found::after_newest, no_parent, nullptr, nullptr, 0.0};
  const Block& first = blocks_.front();
  if (stamp < first.first_stamp()) return {Found::before_oldest, no_parent, nullptr, nullptr, 0.0};
  if (stamp == first.first_stamp()) {
    return {Found::yes, first.parents[first.begin], &first.values[first.begin], nullptr, 0.0};
  }
  return bracket_before(stamp, first_after(stamp));
}

Bracket TimeCache::bracket_before(Stamp stamp, Position newer) const {
  const Block& later = blocks_[newer.block];
  if (newer.index > later.begin) return bracket(stamp, later, newer.index - 1, later, newer.index);
  const Block& earlier = blocks_[newer.block - 1];
  return bracket(stamp, earlier, earlier.stamps.size() - 1, later, newer.index);
}

Bracket TimeCache::search(Stamp stamp, Position& position) const {
  if (size_ < 2 || stamp == latest || stamp <= oldest_stamp() || stamp >= newest_stamp()) return find(stamp);
  position = first_after(stamp);
  return bracket_before(stamp, position);
}

TimeCache::BlockView TimeCache::block(const Position& position) const {
  if (position.block >= blocks_.size()) return {};
  const Block& block = blocks_[position.block];
  if (position.index <= block.begin || position.index >= block.stamps.size()) return {};
  const std::uint64_t first = static_cast<std::uint64_t>(block.first_stamp());
  if (static_cast<std::uint64_t>(block.stamps.back()) - first > INT64_MAX) return {};
  const std::size_t begin = block.begin;
  return {{block.stamps.begin() + begin, block.size()}, block.parents.begin() + begin, block.values.begin() + begin,
          begin, position.index - begin};
}

void TimeCache::view(std::span<const Stamp> stamps, std::span<const FrameId> parents,
                     std::span<const Transform> values) {
  for (std::size_t at = 0; at < stamps.size(); at += block_size) {
    const std::size_t count = std::min(block_size, stamps.size() - at);
    blocks_.push_back({Column(stamps.subspan(at, count)), Column(parents.subspan(at, count)),
                       Column(values.subspan(at, count)), 0});
  }
  size_ = stamps.size();
  if (size_ > 0) refresh_ends();
}

void TimeCache::refresh_ends() {
  oldest_stamp_ = blocks_.front().first_stamp();
  newest_stamp_ = blocks_.back().stamps.back();
  newest_parent_ = blocks_.back().parents.back();
  newest_value_ = &blocks_.back().values.back();
}

void TimeCache::clear() {
  blocks_.clear();
  size_ = 0;
  newest_stamp_ = oldest_stamp_ = 0;
  newest_parent_ = no_parent;
  newest_value_ = nullptr;
}

std::size_t TimeCache::memory() const {
  std::size_t bytes = blocks_.capacity() * sizeof(Block);
  for (const Block& block : blocks_) {
    bytes += block.stamps.capacity() * sizeof(Stamp) + block.parents.capacity() * sizeof(FrameId) +
              block.values.capacity() * sizeof(Transform);
  }
  return bytes;
}

TimeCache::Position TimeCache::first_after(Stamp stamp) const {
  if (empty()) return {};
  if (blocks_.back().stamps.back() <= stamp) return {blocks_.size() - 1, blocks_.back().stamps.size()};
  const auto block = std::upper_bound(blocks_.begin(), blocks_.end(), stamp, [](Stamp value, const Block& candidate) {
    return value < candidate.stamps.back();
  });
  const Stamp* const begin = block->stamps.begin() + block->begin;
  const auto index = std::upper_bound(begin, block->stamps.end(), stamp) - block->stamps.begin();
  return {static_cast<std::size_t>(block - blocks_.begin()), static_cast<std::size_t>(index)};
}

bool TimeCache::contains(const Sample& sample, Position end) const {
  // Those with its stamp are right before `end`, and may continue in the blocks before.
  for (std::size_t b = end.block + 1; b-- > 0 && b < blocks_.size();) {
    const Block& block = blocks_[b];
    for (std::size_t i = b == end.block ? end.index : block.stamps.size(); i-- > block.begin;) {
      if (block.stamps[i] != sample.stamp) return false;
      if (block.parents[i] == sample.parent && block.values[i] == sample.value) return true;
    }
  }
  return false;
}

void TimeCache::prune(Stamp newest) {
  while (!empty() && is_older_than(oldest_stamp(), max_age_, newest)) {
    Block& first = blocks_.front();
    ++first.begin;
    --size_;
    if (first.size() == 0) blocks_.erase(blocks_.begin());
    oldest_stamp_ = blocks_.front().first_stamp();  // the newest sample is never too old, so a block is left
  }
}

}  // namespace tfloom::tf2
