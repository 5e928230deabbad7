#include "core/busy_wait.hpp"

#include <algorithm>
#include <thread>
#ifdef __linux__
#include <sched.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#endif

namespace tfloom {
namespace {

using std::chrono::steady_clock;

constexpr int looks_before_yield = 200;  // about ten microseconds: a yield is a system call

std::atomic<std::uint64_t> messages_sent = 0;

// Let the other thread of the processor's core run, and wait for some tens of nanoseconds.
void pause_briefly() {
#if (defined(__GNUC__) || defined(__clang__)) && (defined(__x86_64__) || defined(__i386__))
  __builtin_ia32_pause();
#elif (defined(__GNUC__) || defined(__clang__)) && (defined(__aarch64__) || defined(__arm__))
  asm volatile("yield");
#endif
}

int usable_processors() {
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return CPU_COUNT(&allowed);
#endif
  return static_cast<int>(std::thread::hardware_concurrency());
}

// Return whether a battery is being discharged; false on systems other than Linux.
bool is_on_battery() {
#ifdef __linux__
  std::error_code error;
  for (const auto& supply : std::filesystem::directory_iterator("/sys/class/power_supply", error)) {
    std::string status;
    std::ifstream(supply.path() / "status") >> status;
    if (status == "Discharging") return true;
  }
#endif
  return false;
}

bool is_allowed() {
  static const bool allowed = usable_processors() > 1 && !is_on_battery();
  return allowed;
}

}  // namespace

void note_message_sent() noexcept { messages_sent.fetch_add(1, std::memory_order_relaxed); }

bool BusyWait::wait(const std::atomic<bool>& is_over, std::optional<std::chrono::nanoseconds> limit) {
  const std::uint64_t sent = messages_sent.load(std::memory_order_relaxed);
  // Without a message since the last wait, there is no reply to expect. `is_allowed` comes last, and looks once,
  // because it reads files.
  const bool was_sent = sent != messages_sent_;
  messages_sent_ = sent;
  if (!was_sent || usual_ > short_wait || !is_allowed()) return false;
  if (pause_left_ > 0) {
    --pause_left_;
    return false;
  }
  if (look(is_over, std::min(limit.value_or(longest), longest))) {
    failures_ = 0;
    return true;
  }
  if (++failures_ == max_failures) {
    failures_ = 0;
    pause_left_ = waits_of_a_pause;
  }
  return false;
}

bool BusyWait::look(const std::atomic<bool>& is_over, std::chrono::nanoseconds time) {
  const auto end = steady_clock::now() + time;
  do {
    for (int look = 0; look < looks_before_yield; ++look) {
      if (is_over.load(std::memory_order_acquire)) return true;
      pause_briefly();
    }
    std::this_thread::yield();  // the thread that is to receive the message may have to run on this processor
  } while (steady_clock::now() < end);
  return false;
}

// The weight of the last wait is a quarter. A long one counts as four times `longest` at most, so that a few short
// waits suffice to forget that the program was idle.
void BusyWait::learn(std::chrono::nanoseconds took) { usual_ += (std::min(took, 4 * longest) - usual_) / 4; }

}  // namespace tfloom
