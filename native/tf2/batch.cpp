#include "tf2/batch.hpp"

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

namespace tfloom::tf2 {
namespace {

constexpr std::size_t chunk_size = 512;

// One link of the chain, with where its history was read last.
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
  void forget_source() { source_links.clear(); }
};

// Fills as many stamps from `start` on as lie between the same two samples, and returns where it stopped; `start`
// where they are too far from each other.
template <std::size_t Terms>
std::size_t climb_between(const Bracket& bracket, std::size_t start, std::span<const Stamp> stamps,
                          std::span<Transform> out, std::span<const std::uint8_t> known, bool is_first) {
  const NearSlerp<Terms> rotation(bracket.older->rotation, bracket.newer->rotation);
  if (!rotation.is_near()) return start;
  const Vector3 from = bracket.older->translation, way = bracket.newer->translation - from;
  // Unsigned, as the difference of extreme stamps overflows.
  const auto begin = static_cast<std::uint64_t>(bracket.older_stamp);
  const std::uint64_t span = static_cast<std::uint64_t>(bracket.newer_stamp) - begin;
  if (span > INT64_MAX) return start;  // below, doubles come of signed numbers, which is faster
  const double per_ns = 1.0 / static_cast<double>(span);
  std::size_t i = start;
  for (; i < stamps.size(); ++i) {
    const Stamp stamp = stamps[i];
    if (stamp <= bracket.older_stamp || stamp >= bracket.newer_stamp || stamp == latest) break;
    if (!known[i]) continue;
    const double r = static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(stamp) - begin)) * per_ns;
    const Transform value{from + r * way, rotation.at(r)};
    out[i] = is_first ? value : value * out[i];
  }
  return i;
}

// Goes up one branch for all stamps, link by link: the histories are read in order, each once. Where a link has no
// data, or another parent than the chain was found with, the stamp is given up.
void climb(std::vector<Link>& links, std::span<const Stamp> stamps, std::span<Transform> out,
           std::span<std::uint8_t> known) {
  bool is_first = true;
  for (Link& link : links) {
    if (link.frame->kind == Frame::Kind::fixed) {
      const Transform& value = link.frame->fixed_value;
      for (std::size_t i = 0; i < stamps.size(); ++i) out[i] = is_first ? value : value * out[i];
    } else {
      for (std::size_t i = 0; i < stamps.size(); ++i) {
        const Bracket bracket = link.find(stamps[i]);
        const bool has_company = bracket.newer && i + 1 < stamps.size() && stamps[i + 1] > bracket.older_stamp &&
                                 stamps[i + 1] < bracket.newer_stamp;
        if (has_company && bracket.parent == link.parent) {
          std::size_t end = climb_between<2>(bracket, i, stamps, out, known, is_first);
          if (end == i) end = climb_between<4>(bracket, i, stamps, out, known, is_first);
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
  const Reading lock(frames_mutex_);
  Ids ids;
  if (!resolve(Query::at(target, source, latest), ids)) {
    if (target != source) return;
    std::ranges::fill(known, std::uint8_t{1});
    std::ranges::fill(out, Transform{});
    return;
  }
  Chain chain{frames_};
  if (stamps[0] != latest && !walk(frames_, ids.target, ids.source, stamps[0], chain)) {
    std::ranges::fill(known, std::uint8_t{1});
    std::array<Transform, chunk_size> to_target;
    const std::span target_side(to_target.data(), stamps.size());
    if (chain.source_links.empty()) std::ranges::fill(out, Transform{});
    climb(chain.source_links, stamps, out, known);
    climb(chain.target_links, stamps, target_side, known);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      if (stamps[i] == latest) known[i] = 0;
      if (!known[i]) continue;
      if (!chain.target_links.empty()) out[i] = inverse(target_side[i]) * out[i];
      out[i].rotation = canonical(out[i].rotation);
    }
  }
  for (std::size_t i = 0; i < stamps.size(); ++i) {  // one by one where the chain is another
    if (known[i]) continue;
    StampedTransform found;
    if (lookup_at(ids.target, ids.source, stamps[i], found)) continue;
    out[i] = found.value;
    known[i] = 1;
  }
}

namespace {

void lookup_range(const Buffer& buffer, std::string_view target, std::string_view source,
                  std::span<const Stamp> stamps, std::span<Transform> out, std::span<std::uint8_t> known,
                  bool is_strict) {
  for (std::size_t start = 0; start < stamps.size(); start += chunk_size) {
    const std::size_t count = std::min(chunk_size, stamps.size() - start);
    const auto chunk = known.subspan(start, count);
    buffer.lookup_chunk(target, source, stamps.subspan(start, count), out.subspan(start, count), chunk);
    if (is_strict && std::ranges::count(chunk, std::uint8_t{0}) > 0) {
      std::ranges::fill(known.subspan(start + count), std::uint8_t{0});
      return;
    }
  }
}

}  // namespace

std::optional<FailedStamp> lookup_many(const Buffer& buffer, std::string_view target, std::string_view source,
                                       std::span<const Stamp> stamps, std::span<Transform> out,
                                       std::span<std::uint8_t> known, bool is_strict, unsigned workers) {
  const std::size_t chunks = (stamps.size() + chunk_size - 1) / chunk_size;
  const std::size_t parts = std::clamp<std::size_t>(workers, 1, std::max<std::size_t>(chunks, 1));
  const std::size_t share = (chunks + parts - 1) / parts * chunk_size;
  const auto run = [&](std::size_t part) {
    const std::size_t start = std::min(part * share, stamps.size());
    const std::size_t count = std::min(share, stamps.size() - start);
    lookup_range(buffer, target, source, stamps.subspan(start, count), out.subspan(start, count),
                 known.subspan(start, count), is_strict);
  };
  std::vector<std::thread> threads;
  for (std::size_t part = 1; part < parts; ++part) threads.emplace_back(run, part);
  run(0);
  for (std::thread& thread : threads) thread.join();
  if (!is_strict) return std::nullopt;
  const auto failed = std::ranges::find(known, std::uint8_t{0});
  if (failed == known.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(failed - known.begin());
  const auto again = buffer.lookup(Query::at(target, source, stamps[index]));
  // An insert in between may have mended it: then the caller is told to try again, by an error without a text.
  return FailedStamp{index, again ? Error{} : again.error()};
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
void move_each_point(const Transform& first, std::span<const Transform> each, const T* in, T* out) {
  for (std::size_t i = 0; i < each.size(); ++i) {
    const Vector3 point{static_cast<double>(in[3 * i]), static_cast<double>(in[3 * i + 1]),
                        static_cast<double>(in[3 * i + 2])};
    const Vector3 halfway = rotate(each[i].rotation, point) + each[i].translation;
    const Vector3 moved = rotate(first.rotation, halfway) + first.translation;
    out[3 * i] = static_cast<T>(moved.x);
    out[3 * i + 1] = static_cast<T>(moved.y);
    out[3 * i + 2] = static_cast<T>(moved.z);
  }
}

template void move_points(const Transform&, const float*, float*, std::size_t);
template void move_points(const Transform&, const double*, double*, std::size_t);
template void move_each_point(const Transform&, std::span<const Transform>, const float*, float*);
template void move_each_point(const Transform&, std::span<const Transform>, const double*, double*);

}  // namespace tfloom::tf2
