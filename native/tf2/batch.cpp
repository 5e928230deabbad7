#include "tf2/batch.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "core/four.hpp"
#include "core/vector_width.hpp"
#include "tf2/branch.hpp"
#include "tf2/columns.hpp"
#include "tf2/stamp_order.hpp"

namespace tfloom::tf2 {
namespace {

constexpr std::size_t chunk_size = 512;

struct Chain {
  const FrameTable& frames;
  std::vector<Link> source_links{}, target_links{};

  void source(FrameId id, const Bracket& link) { source_links.push_back({&frames[id], link.parent}); }
  void target(FrameId id, const Bracket& link) { target_links.push_back({&frames[id], link.parent}); }
  void clear_source() { source_links.clear(); }
};

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
  // One walk finds the chain at the first stamp that isn't `latest`. Then all stamps are composed link by link, in
  // columns. Where a link has another parent at a stamp, or no sample, `known` stays 0.
  Chain chain{frames_};
  const auto first = std::ranges::find_if(stamps, [](Stamp stamp) { return stamp != latest; });
  if (first != stamps.end() && !walk(frames_, ids.target, ids.source, *first, chain)) {
    std::ranges::fill(known, std::uint8_t{1});
    Columns source_side, target_side, value;
    for (std::size_t begin = 0; begin < stamps.size(); begin += Columns::size) {
      const std::size_t count = std::min(Columns::size, stamps.size() - begin);
      const auto part = stamps.subspan(begin, count);
      const auto part_known = known.subspan(begin, count);
      if (chain.source_links.empty()) {
        for (std::size_t i = 0; i < count; ++i) source_side.set(i, Transform{});
      }
      compose_branch(chain.source_links, part, source_side, value, part_known);
      compose_branch(chain.target_links, part, target_side, value, part_known);
      if (!chain.target_links.empty()) column_arithmetic().compose_inverse(target_side, source_side, count);
      for (std::size_t i = 0; i < count; ++i) {
        if (part[i] == latest) part_known[i] = 0;  // left to a single lookup, which finds the common time
        if (!part_known[i]) continue;
        const Transform transform = source_side[i];
        out[begin + i] = {transform.translation, canonical(transform.rotation)};
      }
    }
  }
  for (std::size_t i = 0; i < stamps.size(); ++i) {  // single lookups at stamps where the chain differs
    if (known[i]) continue;
    StampedTransform transform;
    if (lookup_at(ids.target, ids.source, stamps[i], transform)) continue;
    out[i] = transform.value;
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
  std::vector<std::exception_ptr> thrown(parts);  // one place for each part, so that no lock is needed
  const auto run = [&](std::size_t index) {
    const std::size_t start = std::min(index * share, size);
    try {
      work(Part{start, std::min(share, size - start)});
    } catch (const std::exception&) {
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
  // All threads are joined before anything is thrown, because they use the caller's arrays.
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
  constexpr std::size_t max_sorted = std::size_t{1} << 22;
  std::array<Stamp, chunk_size> gathered;
  for (std::size_t begin = 0; begin < stamps.size(); begin += max_sorted) {
    const auto part = stamps.subspan(begin, std::min(max_sorted, stamps.size() - begin));
    const bool is_sorted = std::ranges::is_sorted(part);
    const auto order = is_sorted ? std::vector<std::uint32_t>{} : nearly_ascending(part);
    for (std::size_t start = 0; start < part.size(); start += chunk_size) {
      const std::size_t count = std::min(chunk_size, part.size() - start);
      Chunk chunk{part.subspan(start, count), begin + start, {}};
      if (!is_sorted) {
        // The stamps of this chunk lie anywhere in the part: gather them; `order` has the index of each one.
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
    std::vector<Transform> transforms;
    std::array<std::uint8_t, chunk_size> is_known;
    for_each_chunk(part.of(stamps), [&](const Chunk& chunk) {
      const std::size_t count = chunk.stamps.size();
      if (chunk.order.empty()) {
        const auto answered = own_known.subspan(chunk.start, count);
        buffer.lookup_chunk(target, source, chunk.stamps, own_out.subspan(chunk.start, count), answered);
        if (!is_strict || std::ranges::count(answered, std::uint8_t{0}) == 0) return true;
        // The first stamp that fails in this part is in this chunk or before it. The rest need not be looked up.
        std::ranges::fill(own_known.subspan(chunk.start + count), std::uint8_t{0});
        return false;
      }
      // Of shuffled stamps, a later chunk may have the failing one of the smallest index: look up all.
      transforms.resize(chunk_size);
      buffer.lookup_chunk(target, source, chunk.stamps, std::span(transforms).first(count),
                          std::span(is_known).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = chunk.position(i);
        own_known[at] = is_known[i];
        if (is_known[i]) own_out[at] = transforms[i];
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

namespace {

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

template <class T>
void store(T value, std::byte* to) {
  std::memcpy(to, &value, sizeof(T));
}

}  // namespace

bool CloudLayout::fits(std::size_t size, std::size_t coordinate_size) const {
  if (height == 0 || width == 0) return true;
  const auto take = [&size](std::size_t count, std::size_t step) {
    if (step != 0 && count > size / step) return false;
    size -= count * step;
    return true;
  };
  return take(height - 1, row_step) && take(width - 1, point_step) && take(1, coordinate_size) &&
         std::ranges::max(offsets) <= size;
}

namespace {

// The columns of a matrix [R | t], each with a fourth number, so that x, y and z are computed at once.
template <class T>
struct CloudMatrix {
  explicit CloudMatrix(const Transform& transform) {
    const auto m = rotation_matrix(transform.rotation);
    std::array<T, 9> r{};
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = static_cast<T>(m[i]);
    const auto& p = transform.translation;
    by_x = Four<T>{r[0], r[3], r[6], T{0}};
    by_y = Four<T>{r[1], r[4], r[7], T{0}};
    by_z = Four<T>{r[2], r[5], r[8], T{0}};
    translation = Four<T>{static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z), T{0}};
  }

  Four<T> by_x, by_y, by_z, translation;
};

// Move x, y and z at `point`, and at each `step` bytes from there, as one vector with the number after them, which
// stays as it is.
template <class T>
void move_padded(const CloudMatrix<T>& matrix, std::byte* point, std::size_t step, std::size_t count) {
  const CloudMatrix<T> m = matrix;  // a copy, because the points might overlap the argument
  for (std::size_t i = 0; i < count; ++i, point += step) {
    Four<T> old;
    std::memcpy(&old, point, sizeof old);
    Four<T> moved = m.by_x * old[0] + m.by_y * old[1] + m.by_z * old[2] + m.translation;
    moved[3] = old[3];
    std::memcpy(point, &moved, sizeof moved);
  }
}

#ifdef TFLOOM_WIDE_TARGET
// Its instructions multiply and add at once. Without them, do_transform_cloud of padded points takes 12 % longer:
// benchmarks/native, "wide vectors".
template <class T>
TFLOOM_WIDE_TARGET __attribute__((flatten)) void move_padded_wide(const CloudMatrix<T>& matrix, std::byte* point,
                                                                  std::size_t step, std::size_t count) {
  move_padded(matrix, point, step, count);
}
#endif

// The same for points whose coordinates are anywhere.
template <class T>
void move_scattered(const CloudMatrix<T>& m, const std::array<std::size_t, 3>& offsets, std::byte* point,
                    std::size_t step, std::size_t count) {
  const auto [x, y, z] = offsets;
  for (std::size_t i = 0; i < count; ++i, point += step) {
    Four<T> moved =
        m.by_x * load<T>(point + x) + m.by_y * load<T>(point + y) + m.by_z * load<T>(point + z) + m.translation;
    store<T>(moved[0], point + x);
    store<T>(moved[1], point + y);
    store<T>(moved[2], point + z);
  }
}

}  // namespace

template <class T>
void move_cloud(const Transform& transform, const CloudLayout& layout, std::byte* data) {
  const CloudMatrix<T> matrix(transform);
  auto move_padded_points = &move_padded<T>;
#ifdef TFLOOM_WIDE_TARGET
  if (vectors_are_wide()) move_padded_points = &move_padded_wide<T>;
#endif
  const auto [x, y, z] = layout.offsets;
  const std::size_t step = layout.point_step;
  const bool is_contiguous = y == x + sizeof(T) && z == y + sizeof(T);
  const bool is_packed = is_contiguous && step == 3 * sizeof(T);
  const bool is_padded = is_contiguous && step >= x + 4 * sizeof(T);
  for (std::size_t row = 0; row < layout.height; ++row) {
    std::byte* const first = data + row * layout.row_step;
    if (is_packed && reinterpret_cast<std::uintptr_t>(first + x) % alignof(T) == 0) {
      T* const points = reinterpret_cast<T*>(first + x);
      move_points(transform, points, points, layout.width);
      continue;
    }
    // Not the last point of a row, because the memory may end after its z.
    const std::size_t whole = is_padded && layout.width > 0 ? layout.width - 1 : 0;
    move_padded_points(matrix, first + x, step, whole);
    move_scattered(matrix, layout.offsets, first + whole * step, step, layout.width - whole);
  }
}

template <class T>
std::optional<FailedStamp> deskew(const Buffer& buffer, std::string_view fixed, std::string_view source,
                                  const Transform& target_from_fixed, std::span<const Stamp> stamps, const T* in,
                                  T* out, unsigned workers) {
  std::mutex mutex;  // guards `failed` between the workers
  std::size_t failed = stamps.size();
  run_in_parallel(stamps.size(), workers, [&](const Part& part) {
    std::vector<Transform> transforms(std::min(chunk_size, part.count));
    std::array<std::uint8_t, chunk_size> is_known;
    std::size_t own_failed = stamps.size();
    for_each_chunk(part.of(stamps), [&](const Chunk& chunk) {
      const std::size_t count = chunk.stamps.size();
      buffer.lookup_chunk(fixed, source, chunk.stamps, std::span(transforms).first(count),
                          std::span(is_known).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = part.start + chunk.position(i);
        if (!is_known[i]) own_failed = std::min(own_failed, at);
        if (own_failed < stamps.size()) continue;  // the call fails: only the smallest failing index still matters
        const Vector3 point{static_cast<double>(in[3 * at]), static_cast<double>(in[3 * at + 1]),
                            static_cast<double>(in[3 * at + 2])};
        const Vector3 in_fixed = rotate(transforms[i].rotation, point) + transforms[i].translation;
        const Vector3 moved = rotate(target_from_fixed.rotation, in_fixed) + target_from_fixed.translation;
        out[3 * at] = static_cast<T>(moved.x);
        out[3 * at + 1] = static_cast<T>(moved.y);
        out[3 * at + 2] = static_cast<T>(moved.z);
      }
      // In ascending order, no later chunk fails at a smaller index. Of shuffled stamps, one may.
      return own_failed == stamps.size() || !chunk.order.empty();
    });
    const std::lock_guard lock(mutex);
    failed = std::min(failed, own_failed);
  });
  return failure_of(buffer, fixed, source, stamps, failed);
}

template void move_points(const Transform&, const float*, float*, std::size_t);
template void move_points(const Transform&, const double*, double*, std::size_t);
template void move_cloud<float>(const Transform&, const CloudLayout&, std::byte*);
template void move_cloud<double>(const Transform&, const CloudLayout&, std::byte*);
template std::optional<FailedStamp> deskew(const Buffer&, std::string_view, std::string_view, const Transform&,
                                           std::span<const Stamp>, const float*, float*, unsigned);
template std::optional<FailedStamp> deskew(const Buffer&, std::string_view, std::string_view, const Transform&,
                                           std::span<const Stamp>, const double*, double*, unsigned);

}  // namespace tfloom::tf2
