#include "tf2/batch.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "tf2/stamp_order.hpp"

namespace tfloom::tf2 {
namespace {

constexpr std::size_t chunk_size = 512;

// One link of the chain, with the position of the last read in its history.
struct Link {
  const Frame* frame = nullptr;
  FrameId parent = no_parent;
  TimeCache::Position hint{};

  [[nodiscard]] Bracket find(Stamp stamp) {
    return frame->kind == Frame::Kind::moving ? frame->history->find(stamp, hint) : frame->find(stamp);
  }
};

struct Chain {
  const FrameTable& frames;
  std::vector<Link> source_links{}, target_links{};

  void source(FrameId id, const Bracket& link) { source_links.push_back({&frames[id], link.parent}); }
  void target(FrameId id, const Bracket& link) { target_links.push_back({&frames[id], link.parent}); }
  void clear_source() { source_links.clear(); }
};

// Compose the link for all stamps from `start` on that lie between the two samples of `bracket`. Return the index of
// the first other stamp, or `start` if the rotations of the two samples are too far apart for NearSlerp.
template <std::size_t Terms>
std::size_t compose_between(const Bracket& bracket, std::size_t start, std::span<const Stamp> stamps,
                            std::span<Transform> out, std::span<const std::uint8_t> known, bool is_first) {
  const NearSlerp<Terms> rotation(bracket.older->rotation, bracket.newer->rotation);
  if (!rotation.is_near()) return start;
  const Vector3 from = bracket.older->translation, difference = bracket.newer->translation - from;
  // Unsigned, because the difference of extreme stamps overflows.
  const auto begin = static_cast<std::uint64_t>(bracket.older_stamp);
  const std::uint64_t span = static_cast<std::uint64_t>(bracket.newer_stamp) - begin;
  if (span > INT64_MAX) return start;  // the loop converts signed integers to double, which is faster
  const double per_ns = 1.0 / static_cast<double>(span);
  std::size_t i = start;
  for (; i < stamps.size(); ++i) {
    const Stamp stamp = stamps[i];
    if (stamp <= bracket.older_stamp || stamp >= bracket.newer_stamp || stamp == latest) break;
    if (!known[i]) continue;
    const double r = static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(stamp) - begin)) * per_ns;
    const Transform value{from + r * difference, rotation.at(r)};
    out[i] = is_first ? value : value * out[i];
  }
  return i;
}

// Compose one branch for all stamps, link by link, so that each history is read once and in order. Clear known[i] where
// a link has no data at stamps[i], or has another parent than the chain.
void compose_branch(std::vector<Link>& links, std::span<const Stamp> stamps, std::span<Transform> out,
                    std::span<std::uint8_t> known) {
  bool is_first = true;
  for (Link& link : links) {
    if (link.frame->kind == Frame::Kind::fixed) {
      const Transform& value = link.frame->fixed_value;
      for (std::size_t i = 0; i < stamps.size(); ++i) out[i] = is_first ? value : value * out[i];
    } else {
      for (std::size_t i = 0; i < stamps.size(); ++i) {
        const Bracket bracket = link.find(stamps[i]);
        const bool next_is_between = bracket.newer && i + 1 < stamps.size() && stamps[i + 1] > bracket.older_stamp &&
                                     stamps[i + 1] < bracket.newer_stamp;
        if (next_is_between && bracket.parent == link.parent) {
          std::size_t end = compose_between<2>(bracket, i, stamps, out, known, is_first);
          if (end == i) end = compose_between<4>(bracket, i, stamps, out, known, is_first);
          if (end > i) {
            i = end - 1;
            continue;
          }
        }
        if (bracket.found != Bracket::Found::yes || bracket.parent != link.parent) {
          known[i] = 0;
        } else if (known[i]) {
          out[i] = is_first ? bracket.value() : bracket.value() * out[i];
        }
      }
    }
    is_first = false;
  }
}

}  // namespace

void Buffer::lookup_chunk(std::string_view target, std::string_view source, std::span<const Stamp> stamps,
                          std::span<Transform> out, std::span<std::uint8_t> known) const {
  std::ranges::fill(known, std::uint8_t{0});
  const ReadLock lock(frames_mutex_);
  Ids ids;
  if (!resolve(Query::at(target, source, latest), ids)) {
    if (target != source) return;
    std::ranges::fill(known, std::uint8_t{1});
    std::ranges::fill(out, Transform{});
    return;
  }
  Chain chain{frames_};
  const auto first = std::ranges::find_if(stamps, [](Stamp stamp) { return stamp != latest; });
  if (first != stamps.end() && !walk(frames_, ids.target, ids.source, *first, chain)) {
    std::ranges::fill(known, std::uint8_t{1});
    std::array<Transform, chunk_size> to_target;
    const std::span target_side(to_target.data(), stamps.size());
    if (chain.source_links.empty()) std::ranges::fill(out, Transform{});
    compose_branch(chain.source_links, stamps, out, known);
    compose_branch(chain.target_links, stamps, target_side, known);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      if (stamps[i] == latest) known[i] = 0;
      if (!known[i]) continue;
      if (!chain.target_links.empty()) out[i] = inverse(target_side[i]) * out[i];
      out[i].rotation = canonical(out[i].rotation);
    }
  }
  for (std::size_t i = 0; i < stamps.size(); ++i) {  // single lookups at stamps where the chain differs
    if (known[i]) continue;
    StampedTransform found;
    if (lookup_at(ids.target, ids.source, stamps[i], found)) continue;
    out[i] = found.value;
    known[i] = 1;
  }
}

namespace {

// The stamps of one thread: the index of the first, and their number.
struct Part {
  std::size_t start = 0, count = 0;

  template <class T>
  [[nodiscard]] std::span<T> of(std::span<T> all) const {
    return all.subspan(start, count);
  }
};

// Call work(part) for parts of whole chunks: one on this thread, each other on a new thread. An exception in one of
// them is rethrown here after all have ended.
template <class Work>
void run_in_parallel(std::size_t size, unsigned workers, Work&& work) {
  const std::size_t chunks = (size + chunk_size - 1) / chunk_size;
  const std::size_t most = 4 * std::max(1u, std::thread::hardware_concurrency());
  const std::size_t parts = std::max<std::size_t>(std::min({std::size_t{workers}, most, chunks}), 1);
  const std::size_t share = (chunks + parts - 1) / parts * chunk_size;
  std::vector<std::exception_ptr> thrown(parts);
  const auto run = [&](std::size_t index) {
    const std::size_t start = std::min(index * share, size);
    try {
      work(Part{start, std::min(share, size - start)});
    } catch (...) {
      thrown[index] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(parts);
  std::size_t index = 1;
  try {
    for (; index < parts; ++index) threads.emplace_back(run, index);
  } catch (const std::system_error&) {  // no more threads are available: this one processes the other parts
  }
  run(0);
  for (; index < parts; ++index) run(index);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& one : thrown) {
    if (one) std::rethrow_exception(one);
  }
}

// A few hundred stamps in nearly ascending order.
struct Chunk {
  std::span<const Stamp> stamps;
  std::size_t start = 0;
  std::span<const std::uint32_t> order;  // indices of the stamps relative to `start`; empty: consecutive

  // The index of stamp i among all stamps.
  [[nodiscard]] std::size_t position(std::size_t i) const { return start + (order.empty() ? i : order[i]); }
};

// Call use(chunk) for all stamps, until it returns false. If stamps are looked up in the given order, a lookup of
// shuffled stamps of depth 10 takes 8 times as long: benchmarks/native, "any order".
template <class Use>
void for_each_chunk(std::span<const Stamp> stamps, Use&& use) {
  constexpr std::size_t most_sorted = std::size_t{1} << 22;
  std::array<Stamp, chunk_size> gathered;
  for (std::size_t begin = 0; begin < stamps.size(); begin += most_sorted) {
    const auto part = stamps.subspan(begin, std::min(most_sorted, stamps.size() - begin));
    const bool is_sorted = std::ranges::is_sorted(part);
    const auto order = is_sorted ? std::vector<std::uint32_t>{} : nearly_ascending(part);
    for (std::size_t start = 0; start < part.size(); start += chunk_size) {
      const std::size_t count = std::min(chunk_size, part.size() - start);
      Chunk chunk{part.subspan(start, count), begin + start, {}};
      if (!is_sorted) {
        chunk = {{gathered.data(), count}, begin, std::span(order).subspan(start, count)};
        for (std::size_t i = 0; i < count; ++i) gathered[i] = part[chunk.order[i]];
      }
      if (!use(chunk)) return;
    }
  }
}

std::optional<FailedStamp> failure_of(const Buffer& buffer, std::string_view target, std::string_view source,
                                      std::span<const Stamp> stamps, std::size_t index) {
  if (index == stamps.size()) return std::nullopt;
  const auto again = buffer.lookup(Query::at(target, source, stamps[index]));
  // An insert in between may have added the missing data. An error without a text then makes the caller try again.
  return FailedStamp{index, again ? Error{} : again.error()};
}

}  // namespace

std::optional<FailedStamp> lookup_many(const Buffer& buffer, std::string_view target, std::string_view source,
                                       std::span<const Stamp> stamps, std::span<Transform> out,
                                       std::span<std::uint8_t> known, bool is_strict, unsigned workers) {
  run_in_parallel(stamps.size(), workers, [&](const Part& part) {
    const auto own_out = part.of(out);
    const auto own_known = part.of(known);
    std::vector<Transform> found;
    std::array<std::uint8_t, chunk_size> is_known;
    for_each_chunk(part.of(stamps), [&](const Chunk& chunk) {
      const std::size_t count = chunk.stamps.size();
      if (chunk.order.empty()) {
        const auto answered = own_known.subspan(chunk.start, count);
        buffer.lookup_chunk(target, source, chunk.stamps, own_out.subspan(chunk.start, count), answered);
        if (!is_strict || std::ranges::count(answered, std::uint8_t{0}) == 0) return true;
        std::ranges::fill(own_known.subspan(chunk.start + count), std::uint8_t{0});
        return false;
      }
      found.resize(chunk_size);
      buffer.lookup_chunk(target, source, chunk.stamps, std::span(found).first(count),
                          std::span(is_known).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = chunk.position(i);
        own_known[at] = is_known[i];
        if (is_known[i]) own_out[at] = found[i];
      }
      return true;
    });
  });
  if (!is_strict) return std::nullopt;
  const auto failed = std::ranges::find(known, std::uint8_t{0});
  return failure_of(buffer, target, source, stamps, static_cast<std::size_t>(failed - known.begin()));
}

template <class T>
void move_points(const Transform& transform, const T* in, T* out, std::size_t count) {
  const auto m = rotation_matrix(transform.rotation);
  std::array<T, 9> r{};
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = static_cast<T>(m[i]);
  const auto tx = static_cast<T>(transform.translation.x), ty = static_cast<T>(transform.translation.y),
             tz = static_cast<T>(transform.translation.z);
  for (std::size_t i = 0; i < count; ++i) {
    const T x = in[3 * i], y = in[3 * i + 1], z = in[3 * i + 2];
    out[3 * i] = r[0] * x + r[1] * y + r[2] * z + tx;
    out[3 * i + 1] = r[3] * x + r[4] * y + r[5] * z + ty;
    out[3 * i + 2] = r[6] * x + r[7] * y + r[8] * z + tz;
  }
}

template <class T>
std::optional<FailedStamp> deskew(const Buffer& buffer, std::string_view fixed, std::string_view source,
                                  const Transform& target_from_fixed, std::span<const Stamp> stamps, const T* in,
                                  T* out, unsigned workers) {
  std::mutex mutex;  // guards `failed` between the workers
  std::size_t failed = stamps.size();
  run_in_parallel(stamps.size(), workers, [&](const Part& part) {
    std::vector<Transform> found(std::min(chunk_size, part.count));
    std::array<std::uint8_t, chunk_size> is_known;
    std::size_t own_failed = stamps.size();
    for_each_chunk(part.of(stamps), [&](const Chunk& chunk) {
      const std::size_t count = chunk.stamps.size();
      buffer.lookup_chunk(fixed, source, chunk.stamps, std::span(found).first(count),
                          std::span(is_known).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = part.start + chunk.position(i);
        if (!is_known[i]) own_failed = std::min(own_failed, at);
        if (own_failed < stamps.size()) continue;
        const Vector3 point{static_cast<double>(in[3 * at]), static_cast<double>(in[3 * at + 1]),
                            static_cast<double>(in[3 * at + 2])};
        const Vector3 in_fixed = rotate(found[i].rotation, point) + found[i].translation;
        const Vector3 moved = rotate(target_from_fixed.rotation, in_fixed) + target_from_fixed.translation;
        out[3 * at] = static_cast<T>(moved.x);
        out[3 * at + 1] = static_cast<T>(moved.y);
        out[3 * at + 2] = static_cast<T>(moved.z);
      }
      return own_failed == stamps.size() || !chunk.order.empty();
    });
    const std::lock_guard lock(mutex);
    failed = std::min(failed, own_failed);
  });
  return failure_of(buffer, fixed, source, stamps, failed);
}

template void move_points(const Transform&, const float*, float*, std::size_t);
template void move_points(const Transform&, const double*, double*, std::size_t);
template std::optional<FailedStamp> deskew(const Buffer&, std::string_view, std::string_view, const Transform&,
                                           std::span<const Stamp>, const float*, float*, unsigned);
template std::optional<FailedStamp> deskew(const Buffer&, std::string_view, std::string_view, const Transform&,
                                           std::span<const Stamp>, const double*, double*, unsigned);

}  // namespace tfloom::tf2
