// Wakes one waiting thread, and lets a signal (Ctrl-C) wake it too: a condition variable can't do the second.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#ifdef _WIN32
#include <condition_variable>
#include <mutex>
#endif

namespace tfloom {

class Waker {
 public:
  enum class Outcome { woken, timeout, interrupted };

  class Deadline {
   public:
    explicit Deadline(std::int64_t timeout_ns);  // negative: never
    [[nodiscard]] std::optional<std::chrono::nanoseconds> left() const;  // empty: never; not below zero

   private:
    std::optional<std::chrono::steady_clock::time_point> end_;
  };

  Waker();
  ~Waker();
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  void wake();  // from any thread; wakes that come before the wait are kept, as one
  Outcome wait(const Deadline& deadline);

 private:
#ifdef _WIN32
  std::mutex mutex_;
  std::condition_variable condition_;
  bool woken_ = false;  // guarded by mutex_
#else
  int read_fd_ = -1;  // both constant once constructed: the kernel orders reads and writes
  int write_fd_ = -1;
#endif
};

}  // namespace tfloom
