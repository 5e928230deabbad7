// A tree of frames over time. It stores transforms and computes the transform between any two frames at any time in the
// stored history.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tf2/errors.hpp"
#include "tf2/fair_mutex.hpp"
#include "tf2/frames.hpp"
#include "tf2/log.hpp"
#include "tf2/requests.hpp"
#include "tf2/walk.hpp"

namespace tfloom::tf2 {

// One transform to store: parent_from_child at a time.
struct Entry {
  std::string_view frame_id;
  std::string_view child_frame_id;
  Stamp stamp = 0;
  Transform value;
};

// parent_from_child at many times. Row i has a position x, y, z and a rotation x, y, z, w.
struct Series {
  std::string_view frame_id;
  std::string_view child_frame_id;
  std::span<const Stamp> stamps;
  const double* positions = nullptr;
  const double* rotations = nullptr;

  [[nodiscard]] Entry operator[](std::size_t i) const {
    const double *p = positions + 3 * i, *q = rotations + 4 * i;
    return {frame_id, child_frame_id, stamps[i], {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}}};
  }
};

struct StampedTransform {
  Stamp stamp = 0;
  Transform value;  // target_from_source
};

// A query at one time; or, with `fixed` set, a query between two times: from the source at its stamp, through the fixed
// frame, to the target at its stamp.
struct Query {
  std::string_view target;
  std::string_view source;
  Stamp target_stamp = latest;
  Stamp source_stamp = latest;
  std::optional<std::string_view> fixed;

  static Query at(std::string_view target, std::string_view source, Stamp stamp) {
    return {target, source, stamp, stamp, std::nullopt};
  }
};

// The frames whose data a query at one time reads: the branches of both ends, each from the bottom up to below the top.
// The top is the root or the other end.
struct Branches {
  std::vector<std::string> target, source;
  std::string top;

  // Return the frames from the source to the target, through the frame where the branches meet.
  [[nodiscard]] std::vector<std::string> path() const;
};

// A frame, its newest parent, and the range of its history.
struct Edge {
  std::string child_frame_id, frame_id, authority;  // frame_id: the newest parent
  bool is_static = false;
  Stamp oldest = 0, newest = 0;
  std::size_t sample_count = 0;
};

// Thread-safe. Queries share one lock, and inserts hold it exclusively. Both hold it for about a microsecond, so one
// lock for each frame would cost more than it gains. No callback runs while it is held: the log, the waiting threads
// and the requests are notified afterwards.
class Buffer {
 public:
  static constexpr Stamp default_cache_time = 10'000'000'000;

  explicit Buffer(Stamp cache_time = default_cache_time) : cache_time_(cache_time) {}
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  [[nodiscard]] Stamp cache_time() const { return cache_time_.load(std::memory_order_relaxed); }
  void set_log_callback(LogCallback callback) { log_.set_callback(std::move(callback)); }
  [[nodiscard]] Log& log() { return log_; }
  [[nodiscard]] const Log& log() const { return log_; }
  [[nodiscard]] const Requests& requests() const { return requests_; }
  void drop_callbacks();  // of the log and of all requests, without calling them

  // Store the valid entries under one lock, and return their number; each rejection is logged.
  std::size_t set(std::span<const Entry> entries, std::string_view authority, bool is_static);
  // The same for the transforms of one frame. The lock is acquired again for each thousand, so other inserts and queries
  // may happen in between.
  std::size_t set_many(const Series& series, std::string_view authority);
  // For `duration`, reject moving transforms from this stamp on, without logging them: those sent before a jump back in
  // time and received after it.
  void ignore_from(Stamp stamp, std::chrono::nanoseconds duration);
  void clear();  // empty every history; static transforms, names and authorities stay

  [[nodiscard]] Result<StampedTransform> lookup(const Query& query) const;

  // Look up one chain at up to a few hundred stamps under one lock; see batch.hpp.
  void lookup_chunk(std::string_view target, std::string_view source, std::span<const Stamp> stamps,
                    std::span<Transform> out, std::span<std::uint8_t> known) const;

  [[nodiscard]] bool can(const Query& query) const;
  [[nodiscard]] Error check(const Query& query) const;  // the error of a lookup; Code::ok if it has an answer
  [[nodiscard]] Result<Stamp> latest_common_time(std::string_view target, std::string_view source) const;

  // Wait until the query can be answered. `no`: the deadline has passed, or no further data can answer the query.
  // `interrupted` is returned after each `slice`, so that the caller can check for signals and wait again.
  enum class Waited : std::uint8_t { yes, no, interrupted };
  [[nodiscard]] Waited wait(const Query& query, std::chrono::steady_clock::time_point deadline,
                            std::chrono::nanoseconds slice) const;

  // Call `callback` once, on the thread that inserts, when the query can be answered or can never be answered. The
  // names of the frames are copied. Return `Requests::now` if it can be answered now, and `Requests::never` if it can
  // never be: then `callback` is not called.
  Requests::Handle add_request(const Query& query, Requests::Callback callback);
  bool cancel_request(Requests::Handle handle) { return requests_.cancel(handle); }

  [[nodiscard]] std::vector<Edge> edges() const;  // in order of the children's registration
  // Return the samples of a frame whose parent is `frame_id`, oldest first; a static transform is one, at stamp 0.
  [[nodiscard]] std::vector<Sample> samples(std::string_view frame_id, std::string_view child_frame_id) const;
  // Remove a frame: its name, its transforms and those of its children to it. Return false if it is unknown.
  bool remove_frame(std::string_view name);
  [[nodiscard]] std::size_t memory() const;  // of all histories [bytes]

  // Return the whole contents as the bytes of a frozen buffer; see frozen.hpp.
  [[nodiscard]] std::vector<std::byte> freeze() const;
  // Replace the whole contents and the cache time by those of a frozen buffer. The samples are not copied, and `owner`
  // keeps their memory valid while the buffer exists. Throw FrozenError, with nothing changed, if `frozen` is invalid.
  void map(std::span<const std::byte> frozen, std::shared_ptr<const void> owner);

  // Listings.
  [[nodiscard]] std::vector<std::string> frame_names() const;
  [[nodiscard]] bool has_frame(std::string_view name) const;
  [[nodiscard]] Result<Branches> branches(std::string_view target, std::string_view source, Stamp stamp) const;
  [[nodiscard]] std::string all_frames_as_string() const;
  [[nodiscard]] std::string all_frames_as_yaml(double now_s) const;
  [[nodiscard]] std::string all_frames_as_dot(double now_s) const;

 private:
  using ReadLock = std::shared_lock<FairMutex>;
  enum class Phrase : std::uint8_t { lookup, can };
  enum class Problem : std::uint8_t { self, child_unset, parent_unset, nan, denormalized, old };
  struct Rejection {
    Entry entry;
    Problem problem;
  };
  // The names of the previous transform and their ids, because consecutive transforms often have the same names.
  struct ResolvedNames {
    std::string_view frame_id, child_frame_id;
    FrameId parent = no_parent, child = no_parent;
  };
  struct Ids {
    FrameId target = no_parent, source = no_parent, fixed = no_parent;
  };

  // These require frames_mutex_ to be held:
  [[nodiscard]] std::optional<FrameId> find_frame(std::string_view name) const;
  [[nodiscard]] bool resolve(const Query& query, Ids& ids) const;
  [[nodiscard]] Error name_error(const Query& query, Phrase phrase) const;
  [[nodiscard]] Error name_error_of(std::string_view name, std::string_view where, Phrase phrase) const;
  [[nodiscard]] Failure lookup_at(FrameId target, FrameId source, Stamp stamp, StampedTransform& out) const;
  [[nodiscard]] Failure check_at(FrameId target, FrameId source, Stamp stamp) const;
  [[nodiscard]] Error error_of(const Failure& failure, FrameId target, FrameId source) const;
  [[nodiscard]] Error find_error(const Query& query, const Ids& ids) const;
  [[nodiscard]] bool can_answer(const Query& query) const;
  [[nodiscard]] bool can_never_answer(const Query& query) const;
  [[nodiscard]] bool is_too_old(FrameId target, FrameId source, Stamp stamp) const;
  [[nodiscard]] std::string frames_as_string() const;
  [[nodiscard]] bool is_ignored(Stamp stamp);
  void prefetch_frames(std::span<const Entry> entries) const;
  bool insert(Entry entry, std::string_view authority, bool is_static, ResolvedNames& last,
              std::vector<Rejection>& rejections);
  std::size_t append(const Series& series, std::size_t begin, std::size_t end, std::string_view authority,
                     const ResolvedNames& names);

  void report(const Rejection& rejection, std::string_view authority);
  void notify_waiters();
  [[nodiscard]] Requests::State state_of(const Requests::Request& request) const;

  std::atomic<Stamp> cache_time_;  // written in `map` only, with frames_mutex_ held
  mutable FairMutex frames_mutex_;  // shared by queries, exclusive for changes
  std::shared_ptr<const void> mapped_;  // memory that frames_ may view; guarded by frames_mutex_, like the next three
  FrameTable frames_;
  Stamp ignored_from_ = INT64_MAX;
  std::chrono::steady_clock::time_point ignored_until_;

  // A waiter increments waiters_ before it reads generation_, and an insert increments generation_ before it reads
  // waiters_. Both are sequentially consistent, so at least one of the two threads sees the other's increment.
  mutable std::atomic<std::uint64_t> generation_{0};
  mutable std::atomic<int> waiters_{0};
  mutable std::mutex waiting_mutex_;  // guards no member: it orders a waiter's read before the insert's notification
  mutable std::condition_variable changed_;  // waits with waiting_mutex_

  Requests requests_;  // thread-safe by itself, like the next
  Log log_;
};

}  // namespace tfloom::tf2
