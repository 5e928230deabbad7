#include "core/waker.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#ifdef __linux__
#include <sys/eventfd.h>
#endif
#endif

namespace tfloom {

using std::chrono::nanoseconds;
using std::chrono::steady_clock;

Waker::Deadline::Deadline(std::int64_t timeout_ns) {
  // The sum overflows for timeouts beyond about 146 years, so these count as no deadline.
  constexpr std::int64_t longest = INT64_MAX / 2;
  if (timeout_ns >= 0 && timeout_ns < longest) end_ = steady_clock::now() + nanoseconds(timeout_ns);
}

std::optional<nanoseconds> Waker::Deadline::left() const {
  if (!end_) return std::nullopt;
  return std::max(nanoseconds(0), std::chrono::duration_cast<nanoseconds>(*end_ - steady_clock::now()));
}

#ifdef _WIN32

// Windows runs Ctrl-C handlers on a separate thread, so a long wait returns at this period to check for signals.
constexpr std::chrono::milliseconds signal_check_period(50);

Waker::Waker() = default;
Waker::~Waker() = default;

void Waker::wake() {
  {
    const std::lock_guard lock(mutex_);
    woken_ = true;
  }
  condition_.notify_one();
}

Waker::Outcome Waker::wait(const Deadline& deadline, int) {
  std::unique_lock lock(mutex_);
  const auto left = deadline.left();
  const nanoseconds slice = left ? std::min<nanoseconds>(*left, signal_check_period) : signal_check_period;
  if (condition_.wait_for(lock, slice, [this] { return woken_; })) {
    woken_ = false;
    return Outcome::woken;
  }
  return left && *left <= slice ? Outcome::timeout : Outcome::interrupted;
}

#else

Waker::Waker() {
#ifdef __linux__
  read_fd_ = write_fd_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (read_fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
#else
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int fd : ends) {
    fcntl(fd, F_SETFD, FD_CLOEXEC);
    fcntl(fd, F_SETFL, O_NONBLOCK);
  }
  read_fd_ = ends[0];
  write_fd_ = ends[1];
#endif
}

Waker::~Waker() {
  close(read_fd_);
  if (write_fd_ != read_fd_) close(write_fd_);
}

void Waker::wake() {
  const std::uint64_t one = 1;
  // If the pipe or counter is full, a wake-up is already pending. Only an interrupted write is repeated.
  while (write(write_fd_, &one, sizeof one) < 0 && errno == EINTR) {
  }
}

Waker::Outcome Waker::wait(const Deadline& deadline, int interrupt_fd) {
  pollfd watched[] = {{.fd = read_fd_, .events = POLLIN, .revents = 0},
                      {.fd = interrupt_fd, .events = POLLIN, .revents = 0}};
  const auto left = deadline.left();
#ifdef __linux__
  timespec limit{};
  if (left) {
    limit.tv_sec = static_cast<time_t>(left->count() / 1'000'000'000);
    limit.tv_nsec = static_cast<long>(left->count() % 1'000'000'000);
  }
  const int ready = ppoll(watched, std::size(watched), left ? &limit : nullptr, nullptr);
#else
  constexpr std::int64_t max_ms = 1'000'000'000;
  const int limit_ms =
      left ? static_cast<int>(std::min<std::int64_t>((left->count() + 999'999) / 1'000'000, max_ms)) : -1;
  const int ready = poll(watched, std::size(watched), limit_ms);
#endif
  if (ready < 0) {
    if (errno == EINTR) return Outcome::interrupted;
    throw std::system_error(errno, std::generic_category(), "poll");
  }
  if (ready == 0) return Outcome::timeout;
  if (watched[1].revents != 0) return Outcome::interrupted;  // a wake-up, too, stays for the next wait
  std::uint64_t drained[32];
  while (read(read_fd_, drained, sizeof drained) == sizeof drained) {
  }
  return Outcome::woken;
}

#endif

}  // namespace tfloom
