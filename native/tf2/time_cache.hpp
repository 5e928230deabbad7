// The history of one frame: samples in order of time, in contiguous blocks.
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

// stamp + age < newest, where the sum may lie beyond the range. Nothing is older than unlimited.
constexpr bool is_older_than(Stamp stamp, Stamp age, Stamp newest) {
  return age != unlimited && stamp <= INT64_MAX - age && stamp + age < newest;
}

struct Sample {
  Stamp stamp = 0;
  FrameId parent = no_parent;
  Transform value;  // parent_from_child

  friend bool operator==(const Sample&, const Sample&) = default;
};

// The stored samples that a query falls on: one, or the two to interpolate between.
struct Bracket {
  enum class Found : std::uint8_t { yes, empty, only_one, after_newest, before_oldest };

  Found found = Found::empty;
  FrameId parent = no_parent;
  const Transform* older = nullptr;
  const Transform* newer = nullptr;  // null: `older` is the answer
  double ratio = 0.0;
  Stamp older_stamp = 0, newer_stamp = 0;  // where there are two

  [[nodiscard]] Transform value() const { return newer ? interpolate(*older, *newer, ratio) : *older; }
};

// Samples ascend by stamp; among equal stamps, in order of arrival. Binary search finds the block, then the sample,
// so an insert anywhere moves part of one block, and pruning from the old end moves nothing.
class TimeCache {
 public:
  static constexpr std::size_t block_size = 256;

  explicit TimeCache(Stamp max_age) : max_age_(max_age) {}

  // False: older than the newest sample by more than the maximum age, and not stored. What's identical to a stored
  // sample is not stored again. Pruning goes by what was stored before, so it lags by one insert, as users of
  // sparse transforms rely on.
  bool insert(const Sample& sample);

  // Two steps ahead of inserts after the newest sample: fetch what leads to the memory they touch, then that.
  void prefetch_blocks() const;
  void prefetch_ends() const;

  // The answer's pointers live until the next change. `stamp` of `latest` is the newest sample.
  [[nodiscard]] Bracket find(Stamp stamp) const;

  // The same for stamps that mostly ascend: `hint` is where the last one was found, and at first {}. Without it,
  // lookup_many takes 23 % longer: benchmarks/native, "search hint".
  struct Position {
    std::size_t block = 0, index = 0;
  };
  [[nodiscard]] Bracket find(Stamp stamp, Position& hint) const {
    if (hint.block < blocks_.size()) {
      const Block& block = blocks_[hint.block];
      // The sample before must be in the block too, and no stamp of an end is between two samples.
      const std::size_t end = std::min(hint.index + 3, block.stamps.size());
      for (std::size_t index = std::max(hint.index, block.begin + 1); index < end; ++index) {
        if (block.stamps[index] <= stamp) continue;
        if (block.stamps[index - 1] > stamp || stamp == blocks_.front().first_stamp() || stamp == latest) break;
        hint.index = index;
        return bracket(stamp, block, index - 1, block, index);
      }
    }
    return search(stamp, hint);
  }

  // Takes samples where they lie, which must ascend and outlive the cache; they're copied block by block as inserts
  // come to them. Only for an empty cache.
  void view(std::span<const Stamp> stamps, std::span<const FrameId> parents, std::span<const Transform> values);

  void clear();

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Stamp newest_stamp() const { return newest_stamp_; }
  [[nodiscard]] Stamp oldest_stamp() const { return oldest_stamp_; }
  [[nodiscard]] FrameId newest_parent() const { return newest_parent_; }
  [[nodiscard]] const Transform* newest_value() const { return newest_value_; }  // null: empty
  [[nodiscard]] std::size_t memory() const;  // octets, without those viewed

  // Calls visit(stamp, parent, transform) for each sample, oldest first.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (const Block& block : blocks_) {
      for (std::size_t i = block.begin; i < block.stamps.size(); ++i) {
        visit(block.stamps[i], block.parents[i], block.values[i]);
      }
    }
  }

 private:
  // A structure of arrays: a search touches stamps only. Full blocks hold 68 octets a sample.
  struct Block {
    Column<Stamp> stamps;
    Column<FrameId> parents;
    Column<Transform> values;
    std::size_t begin = 0;  // what is before it has been pruned

    [[nodiscard]] Stamp first_stamp() const { return stamps[begin]; }
    [[nodiscard]] std::size_t live() const { return stamps.size() - begin; }
    void insert(std::size_t index, const Sample& sample);
    void reserve();
    void drop_pruned();
    [[nodiscard]] Block split();
  };

  [[nodiscard]] Position after(Stamp stamp) const;  // of the first sample later than `stamp`
  [[nodiscard]] bool holds(const Sample& sample, Position end) const;
  [[nodiscard]] Bracket before(Stamp stamp, Position newer) const;
  [[nodiscard]] Bracket search(Stamp stamp, Position& hint) const;

  [[nodiscard]] static Bracket bracket(Stamp stamp, const Block& earlier, std::size_t older, const Block& later,
                                       std::size_t newer) {
    Bracket found{Bracket::Found::yes, earlier.parents[older], &earlier.values[older], nullptr, 0.0};
    if (later.parents[newer] != found.parent) return found;  // the old parent holds until the new one starts
    found.newer = &later.values[newer];
    // Unsigned, as the difference of extreme stamps overflows.
    found.older_stamp = earlier.stamps[older];
    found.newer_stamp = later.stamps[newer];
    const auto start = static_cast<std::uint64_t>(found.older_stamp);
    const auto span = static_cast<double>(static_cast<std::uint64_t>(found.newer_stamp) - start);
    found.ratio = static_cast<double>(static_cast<std::uint64_t>(stamp) - start) / span;
    return found;
  }
  void prune();
  void note_ends();

  Stamp max_age_;
  std::size_t size_ = 0;
  std::vector<Block> blocks_;  // none is empty
  // The ends again, which most inserts and queries read alone. The pointer is into the last block.
  Stamp newest_stamp_ = 0, oldest_stamp_ = 0;
  FrameId newest_parent_ = no_parent;
  const Transform* newest_value_ = nullptr;
};

}  // namespace tfloom::tf2
