// The history of one frame: samples ordered by stamp, in contiguous blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tf2/column.hpp"
#include "tf2/errors.hpp"
#include "tf2/transform.hpp"

namespace tfloom::tf2 {

using FrameId = std::uint32_t;

inline constexpr FrameId no_parent = 0;
inline constexpr Stamp unlimited = INT64_MAX;

// Return stamp + age < newest, without overflow of the sum. With an unlimited age, nothing is too old.
constexpr bool is_older_than(Stamp stamp, Stamp age, Stamp newest) {
  return age != unlimited && stamp <= INT64_MAX - age && stamp + age < newest;
}

struct Sample {
  Stamp stamp = 0;
  FrameId parent = no_parent;
  Transform value;  // parent_from_child

  friend bool operator==(const Sample&, const Sample&) = default;
};

// The stored samples that answer a query: one, or two to interpolate between.
struct Bracket {
  enum class Found : std::uint8_t { yes, empty, only_one, after_newest, before_oldest };

  Found found = Found::empty;
  FrameId parent = no_parent;
  const Transform* older = nullptr;
  const Transform* newer = nullptr;  // null: `older` is the answer
  double ratio = 0.0;
  Stamp older_stamp = 0, newer_stamp = 0;  // set if there are two

  [[nodiscard]] Transform value() const { return newer ? interpolate(*older, *newer, ratio) : *older; }
};

// Samples ascend by stamp; those with equal stamps are in order of arrival. Binary search finds the block, then the
// sample. An insert moves part of one block at most, and pruning the oldest samples moves none.
class TimeCache {
 public:
  static constexpr std::size_t block_size = 256;

  explicit TimeCache(Stamp max_age) : max_age_(max_age) {}

  // Store a sample, unless an identical one is stored. Return false, and store nothing, if it is older than the newest
  // sample by more than the maximum age. Pruning uses the newest stamp before the insert, so it lags by one insert;
  // users of sparse transforms rely on that.
  bool insert(const Sample& sample);

  // Store samples of one parent, as `insert` does for each. The cache must not be empty, and each stamp must be greater
  // than the one before it, the first greater than the newest stored one.
  void append(std::span<const Stamp> stamps, FrameId parent, std::span<const Transform> values);

  // Two steps to prefetch the memory of an insert after the newest sample: first the blocks' pointers, then the ends of
  // their columns.
  void prefetch_blocks() const;
  void prefetch_ends() const;

  // The pointers in the result are valid until the next change. A `stamp` of `latest` finds the newest sample.
  [[nodiscard]] Bracket find(Stamp stamp) const;

  // The block and index of a sample. The same, and set `position` to that of the first sample after `stamp`, if there is
  // one before it too.
  struct Position {
    std::size_t block = 0, index = 0;
  };
  [[nodiscard]] Bracket search(Stamp stamp, Position& position) const;

  // The samples of one block, and the index of one that has another before it; empty if there is none at `position`, or
  // if the difference of two stamps could overflow. Valid until the next change.
  struct BlockView {
    std::span<const Stamp> stamps;
    const FrameId* parents = nullptr;
    const Transform* values = nullptr;
    std::size_t begin = 0;  // the block's samples before it are pruned
    std::size_t index = 0;  // of the sample at `position`, from `begin` on
  };
  [[nodiscard]] BlockView block(const Position& position) const;

  // View samples in place. They must ascend and outlive the cache; an insert copies the block that it changes. The
  // cache must be empty.
  void view(std::span<const Stamp> stamps, std::span<const FrameId> parents, std::span<const Transform> values);

  void clear();

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Stamp newest_stamp() const { return newest_stamp_; }
  [[nodiscard]] Stamp oldest_stamp() const { return oldest_stamp_; }
  [[nodiscard]] FrameId newest_parent() const { return newest_parent_; }
  [[nodiscard]] const Transform* newest_value() const { return newest_value_; }  // null: empty
  [[nodiscard]] std::size_t memory() const;  // bytes, without those viewed

  // Call visit(stamp, parent, transform) for each sample, oldest first.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (const Block& block : blocks_) {
      for (std::size_t i = block.begin; i < block.stamps.size(); ++i) {
        visit(block.stamps[i], block.parents[i], block.values[i]);
      }
    }
  }

 private:
  // A structure of arrays, so that a search reads stamps only. A full block takes 68 bytes a sample.
  struct Block {
    Column<Stamp> stamps;
    Column<FrameId> parents;
    Column<Transform> values;
    std::size_t begin = 0;  // the samples before it are pruned

    [[nodiscard]] Stamp first_stamp() const { return stamps[begin]; }
    [[nodiscard]] std::size_t size() const { return stamps.size() - begin; }
    void insert(std::size_t index, const Sample& sample);
    void reserve();
    void drop_pruned();
    [[nodiscard]] Block split();
  };

  [[nodiscard]] Position first_after(Stamp stamp) const;  // of the first sample later than `stamp`
  [[nodiscard]] bool contains(const Sample& sample, Position end) const;
  [[nodiscard]] Bracket bracket_before(Stamp stamp, Position newer) const;

  [[nodiscard]] static Bracket bracket(Stamp stamp, const Block& earlier, std::size_t older, const Block& later,
                                       std::size_t newer) {
    Bracket found{Bracket::Found::yes, earlier.parents[older], &earlier.values[older], nullptr, 0.0};
    if (later.parents[newer] != found.parent) return found;  // the old parent is valid until the new one's first stamp
    found.newer = &later.values[newer];
    // Unsigned, because the difference of extreme stamps overflows.
    found.older_stamp = earlier.stamps[older];
    found.newer_stamp = later.stamps[newer];
    const auto start = static_cast<std::uint64_t>(found.older_stamp);
    const auto span = static_cast<double>(static_cast<std::uint64_t>(found.newer_stamp) - start);
    found.ratio = static_cast<double>(static_cast<std::uint64_t>(stamp) - start) / span;
    return found;
  }
  void prune(Stamp newest);  // drop the samples that are too old if `newest` is the newest stamp
  void refresh_ends();

  Stamp max_age_;
  std::size_t size_ = 0;
  std::vector<Block> blocks_;  // none is empty
  // Copies of both ends, because most inserts and queries read nothing else. The pointer is into the last block.
  Stamp newest_stamp_ = 0, oldest_stamp_ = 0;
  FrameId newest_parent_ = no_parent;
  const Transform* newest_value_ = nullptr;
};

}  // namespace tfloom::tf2
