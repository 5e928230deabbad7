#include "tf2/branch.hpp"

#include <array>
#include <cstddef>

namespace tfloom::tf2 {
namespace {

// The transforms of one moving link at the stamps of a chunk.
class LinkAtStamps {
 public:
  LinkAtStamps(Link& link, std::span<const Stamp> stamps, Columns& out, std::span<std::uint8_t> known)
      : link_(link), history_(*link.frame->history), stamps_(stamps), out_(out), known_(known) {}

  void compute() {
    std::size_t i = 0;
    while ((i = use_block(i)) < stamps_.size()) search(i++);
    interpolate_pairs(i);
  }

 private:
  static constexpr std::size_t long_run = 8;  // stamps between the same two samples

  // Interpolate at the stamps from `i` on, as long as they ascend within the block of the hint. Return the index of the
  // first other stamp. With a search for each stamp, lookup_many takes 3.4 times as long: benchmarks/native, "search hint".
  std::size_t use_block(std::size_t i) {
    const auto block = history_.block(link_.hint);
    if (block.stamps.empty()) return i;
    std::size_t newer = block.index;
    const Stamp last = block.stamps.back();
    while (i < stamps_.size()) {
      const Stamp stamp = stamps_[i];
      if (stamp < block.stamps[newer - 1] || stamp >= last || stamp <= history_.oldest_stamp() || stamp == latest) break;
      while (block.stamps[newer] <= stamp) ++newer;  // ends, because the last is later
      if (block.parents[newer - 1] != link_.parent || block.parents[newer] != link_.parent) break;
      const Between between{block.values[newer - 1], block.values[newer], block.stamps[newer - 1], block.stamps[newer]};
      const bool is_long = stamps_.size() - i >= long_run && between.contains(stamps_[i + long_run - 1]);
      i = is_long ? use_long_run(i, between) : use_run(i, between);
    }
    link_.hint.index = block.begin + newer;
    return i;
  }

  struct Between {
    const Transform &older, &newer;
    Stamp older_stamp, newer_stamp;

    [[nodiscard]] bool contains(Stamp stamp) const { return stamp >= older_stamp && stamp < newer_stamp; }
    [[nodiscard]] double distance() const { return static_cast<double>(newer_stamp - older_stamp); }
    [[nodiscard]] double elapsed(Stamp stamp) const { return static_cast<double>(stamp - older_stamp); }
  };

  // Each returns the index of the first stamp from `i` on that is not between the two samples.
  std::size_t use_run(std::size_t i, const Between& between) {
    const double distance = between.distance();
    do {
      pairs_.set(i, between.older, between.newer, between.elapsed(stamps_[i]), distance);
    } while (++i < stamps_.size() && between.contains(stamps_[i]));
    return i;
  }
  std::size_t use_long_run(std::size_t begin, const Between& between) {
    const NearSlerp rotation(between.older.rotation, between.newer.rotation);
    if (!rotation.is_near()) return use_run(begin, between);
    interpolate_pairs(begin);
    const double per_ns = 1.0 / between.distance();
    std::array<double, Columns::size + Columns::lanes> ratios;
    std::size_t count = 0;
    for (std::size_t i = begin; i < stamps_.size() && between.contains(stamps_[i]); ++i) {
      ratios[count++] = between.elapsed(stamps_[i]) * per_ns;
    }
    for (std::size_t i = 0; i < Columns::lanes; ++i) ratios[count + i] = 0.0;
    arithmetic_.interpolate(between.older.translation, between.newer.translation, rotation, ratios.data(), count, begin,
                            out_);
    return first_pair_ = begin + count;
  }

  // Find one stamp, anywhere in the history.
  void search(std::size_t i) {
    static constexpr Transform identity;
    const Bracket bracket = history_.search(stamps_[i], link_.hint);
    if (bracket.found != Bracket::Found::yes || bracket.parent != link_.parent) {
      known_[i] = 0;
      return pairs_.set(i, identity, identity, 0.0, 1.0);
    }
    pairs_.set(i, *bracket.older, bracket.newer ? *bracket.newer : *bracket.older, bracket.ratio, 1.0);
  }

  // Interpolate the pairs before row `end` that are not interpolated yet.
  void interpolate_pairs(std::size_t end) {
    if (first_pair_ == end) return;
    for (std::size_t i = 0; i < Columns::lanes; ++i) {  // whole vectors; these rows are written again or not read
      pairs_.set(end + i, *pairs_.older[end - 1], *pairs_.newer[end - 1], 0.0, 1.0);
    }
    arithmetic_.interpolate_pairs(pairs_, first_pair_, end, out_);
    first_pair_ = end;
  }

  Link& link_;
  const TimeCache& history_;
  std::span<const Stamp> stamps_;
  Columns& out_;
  std::span<std::uint8_t> known_;
  const ColumnArithmetic& arithmetic_ = column_arithmetic();
  Pairs pairs_;
  std::size_t first_pair_ = 0;  // the first row of `pairs_` that is not interpolated yet
};

}  // namespace

void compose_branch(std::vector<Link>& links, std::span<const Stamp> stamps, Columns& out, Columns& value,
                    std::span<std::uint8_t> known) {
  const ColumnArithmetic& arithmetic = column_arithmetic();
  bool is_first = true;
  for (Link& link : links) {
    if (link.frame->kind == Frame::Kind::fixed) {
      if (is_first) {
        for (std::size_t i = 0; i < stamps.size(); ++i) out.set(i, link.frame->fixed_value);
      } else {
        arithmetic.compose_fixed(link.frame->fixed_value, out, stamps.size());
      }
    } else if (is_first) {
      LinkAtStamps(link, stamps, out, known).compute();
    } else {
      LinkAtStamps(link, stamps, value, known).compute();
      arithmetic.compose(value, out, stamps.size());
    }
    is_first = false;
  }
}

}  // namespace tfloom::tf2
