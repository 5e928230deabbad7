// Queries that wait for their data, each with a callback. Async lookups and message filters use them.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tf2/errors.hpp"

namespace tfloom::tf2 {

class Requests {
 public:
  using Handle = std::uint64_t;
  static constexpr Handle now = 0;
  static constexpr Handle never = UINT64_MAX;

  enum class Outcome : std::uint8_t { available, failed };
  // Called with no lock held, so it may call `add`, `cancel` and `Buffer::set`.
  using Callback = std::function<void(Handle, Outcome)>;

  struct Request {
    Handle handle = 0;
    std::string target, source, fixed;
    bool is_full = false;
    Stamp target_stamp = 0, source_stamp = 0;
    Callback callback;
  };
  enum class State : std::uint8_t { pending, available, failed };

  Handle add(Request request);
  bool cancel(Handle handle);
  void clear();  // cancel all

  // Call `visit(callback)` for each pending request, with the lock held.
  template <class Visit>
  void for_each_callback(Visit&& visit) const {
    const std::lock_guard lock(mutex_);
    for (const auto& request : requests_) visit(request->callback);
  }

  // Remove each request whose `state_of(request)` is not pending, and call it back in order of arrival.
  template <class StateOf>
  void complete(StateOf&& state_of) {
    // Most inserts find no request, and acquire no lock. One that is added just now is checked by `Buffer::add_request`
    // itself, after it has been added.
    if (count_.load() == 0) return;
    std::vector<std::pair<std::shared_ptr<const Request>, Outcome>> completed;
    {
      const std::lock_guard lock(mutex_);
      std::erase_if(requests_, [&](const std::shared_ptr<const Request>& request) {
        const State state = state_of(*request);
        if (state == State::pending) return false;
        completed.emplace_back(request, state == State::available ? Outcome::available : Outcome::failed);
        return true;
      });
      count_.store(requests_.size());
    }
    for (const auto& [request, outcome] : completed) request->callback(request->handle, outcome);
  }

 private:
  mutable std::mutex mutex_;  // acquired before Buffer::frames_mutex_, which `state_of` acquires
  std::atomic<std::size_t> count_{0};  // of requests_; written with mutex_ held
  Handle last_ = 0;                    // guarded by mutex_, like the next
  std::vector<std::shared_ptr<const Request>> requests_;
};

}  // namespace tfloom::tf2
