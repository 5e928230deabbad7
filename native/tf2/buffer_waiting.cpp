// Waiting for data in a buffer: threads wait on a condition variable, requests are called back.
#include <algorithm>

#include "tf2/buffer.hpp"

namespace tfloom::tf2 {
namespace {

// Counts one waiter for its lifetime.
class WaiterCount {
 public:
  explicit WaiterCount(std::atomic<int>& count) : count_(count) { ++count_; }
  WaiterCount(const WaiterCount&) = delete;
  WaiterCount& operator=(const WaiterCount&) = delete;
  ~WaiterCount() { --count_; }

 private:
  std::atomic<int>& count_;
};

bool is_valid_name(std::string_view name) { return !name.empty() && !name.starts_with('/'); }

Query query_of(const Requests::Request& request) {
  Query query{request.target, request.source, request.target_stamp, request.source_stamp, std::nullopt};
  if (request.is_full) query.fixed = request.fixed;
  return query;
}

}  // namespace

void Buffer::notify_waiters() {
  generation_.fetch_add(1);
  if (waiters_.load() > 0) {
    { const std::lock_guard lock(waiting_mutex_); }  // each waiter now either waits or has read the new generation
    changed_.notify_all();
  }
  requests_.complete([this](const Requests::Request& request) { return state_of(request); });
}

Buffer::Waited Buffer::wait(const Query& query, std::chrono::steady_clock::time_point deadline,
                            std::chrono::nanoseconds slice) const {
  using Clock = std::chrono::steady_clock;
  const WaiterCount count(waiters_);
  const auto slice_end = std::min(deadline, Clock::now() + slice);
  for (;;) {
    // Read before the check: data that is inserted after the check changes the generation, and the wait ends at once.
    const std::uint64_t seen = generation_.load();
    {
      const ReadLock lock(frames_mutex_);
      if (can_answer(query)) return Waited::yes;
      if (can_never_answer(query)) return Waited::no;
    }
    std::unique_lock waiting(waiting_mutex_);
    if (!changed_.wait_until(waiting, slice_end, [&] { return generation_.load() != seen; })) {
      return Clock::now() >= deadline ? Waited::no : Waited::interrupted;
    }
  }
}

bool Buffer::is_too_old(FrameId target, FrameId source, Stamp stamp) const {
  if (stamp == latest || target == source) return false;
  const CommonTime common = tf2::latest_common_time(frames_, target, source);
  return !common.failure && common.stamp != 0 && is_older_than(stamp, cache_time_, common.stamp);
}

bool Buffer::can_never_answer(const Query& query) const {
  for (const std::string_view name : {query.target, query.source, query.fixed.value_or("-")}) {
    if (!is_valid_name(name)) return true;
  }
  Ids ids;
  if (!resolve(query, ids)) return false;
  if (!query.fixed) return is_too_old(ids.target, ids.source, query.target_stamp);
  return is_too_old(ids.fixed, ids.source, query.source_stamp) ||
         is_too_old(ids.target, ids.fixed, query.target_stamp);
}

Requests::State Buffer::state_of(const Requests::Request& request) const {
  const Query query = query_of(request);
  const ReadLock lock(frames_mutex_);
  if (can_never_answer(query)) return Requests::State::failed;
  return can_answer(query) ? Requests::State::available : Requests::State::pending;
}

void Buffer::drop_callbacks() {
  log_.set_callback({});
  requests_.clear();
}

Requests::Handle Buffer::add_request(const Query& query, Requests::Callback callback) {
  // Added before the check, so that an insert between the two completes it; it can then no longer be cancelled.
  const Requests::Handle handle = requests_.add({.handle = 0,
                                                 .target = std::string(query.target),
                                                 .source = std::string(query.source),
                                                 .fixed = std::string(query.fixed.value_or("")),
                                                 .is_full = query.fixed.has_value(),
                                                 .target_stamp = query.target_stamp,
                                                 .source_stamp = query.source_stamp,
                                                 .callback = std::move(callback)});
  bool can = false, never = false;
  {
    const ReadLock lock(frames_mutex_);
    can = can_answer(query);
    never = !can && can_never_answer(query);
  }
  if (!can && !never) return handle;
  if (!requests_.cancel(handle)) return handle;
  return can ? Requests::now : Requests::never;
}

}  // namespace tfloom::tf2
