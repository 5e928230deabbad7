// A buffer's log of rejected data. It is throttled here, so that a flood of bad data gives one line a second.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace tfloom::tf2 {

// The numbers of rcl's logger and of Python's logging.
enum class Severity : std::uint8_t { warn = 30, error = 40 };

using LogCallback = std::function<void(Severity severity, const std::string& text)>;

// Thread-safe. Calls the callback on the thread that reports, with no lock held.
class Log {
 public:
  void set_callback(LogCallback callback);

  // Call `visit(callback)` with the lock held, if there is a callback and no thread is calling it.
  template <class Visit>
  void visit_callback(Visit&& visit) const {
    const std::lock_guard lock(mutex_);
    if (callback_.use_count() == 1) visit(*callback_);
  }

  // Pass on one text a second for each (topic, frame); the next one passed on states how many were held back.
  void report(Severity severity, std::string_view topic, std::string_view frame, std::string text);

 private:
  using Clock = std::chrono::steady_clock;
  struct Recent {
    Clock::time_point last;
    std::uint64_t held_back = 0;
  };
  static constexpr std::chrono::seconds period{1};
  static constexpr std::size_t max_remembered = 1024;  // names come from the wire: bounded

  Recent& recent(std::string_view topic, std::string_view frame, Clock::time_point now);

  mutable std::mutex mutex_;
  std::shared_ptr<const LogCallback> callback_;  // guarded by mutex_, like the next
  std::map<std::pair<std::string, std::string>, Recent> recent_;
};

}  // namespace tfloom::tf2
