// Wake one waiting thread from another thread. A signal (Ctrl-C) ends the wait too, unlike that of a condition
// variable.
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
    explicit Deadline(std::int64_t timeout_ns);  // negative: no deadline
    [[nodiscard]] std::optional<std::chrono::nanoseconds> left() const;  // zero or more; empty: no deadline

   private:
    std::optional<std::chrono::steady_clock::time_point> end_;
  };

  Waker();
  ~Waker();
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  void wake();  // from any thread; calls before the wait count as one wake-up, which ends it at once

  // Wait for a wake-up. `interrupted`: a signal handler ran on this thread, or there is something to read from
  // `interrupt_fd`, which is left to the caller; a negative one is ignored. On Windows it is returned periodically.
  Outcome wait(const Deadline& deadline, int interrupt_fd = -1);

 private:
#ifdef _WIN32
  std::mutex mutex_;
  std::condition_variable condition_;
  bool woken_ = false;  // guarded by mutex_
#else
  int read_fd_ = -1;  // both constant after construction: the kernel orders reads and writes
  int write_fd_ = -1;
#endif
};

}  // namespace tfloom
