// Wait for an event without sleeping, where it usually comes sooner than a sleeping thread wakes.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace tfloom {

// To be called after each message that this process sends: what is waited for next may be the reply to it.
void note_message_sent() noexcept;

// The policy of one waiting thread. A sleep and the wake-up from it take some tens of microseconds, on both sides of a
// round trip. A busy wait saves them and occupies a processor, so it is used only if
//   - a message was sent since the last wait, so that a reply may be near. A listener never waits like this;
//   - the last waits were shorter than `short_wait`;
//   - not `max_failures` busy waits in a row ended without the event. Then the next `waits_of_a_pause` waits sleep:
//     a program that gets no replies spends less than a twentieth of its time in busy waits;
//   - the machine has two processors or more, and doesn't run on its battery.
class BusyWait {
 public:
  static constexpr std::chrono::nanoseconds longest{250'000};
  // Longer than `longest`, because a reply takes longer while the two sides still sleep.
  static constexpr std::chrono::nanoseconds short_wait{500'000};
  static constexpr int max_failures = 4;
  static constexpr int waits_of_a_pause = 100;

  // Wait until `is_over` is set, for `limit` and for `longest` at most. Return false at once if the policy is against it.
  bool wait(const std::atomic<bool>& is_over, std::optional<std::chrono::nanoseconds> limit);

  // Learn how long a whole wait took, busy or not.
  void learn(std::chrono::nanoseconds took);

 private:
  static bool look(const std::atomic<bool>& is_over, std::chrono::nanoseconds time);

  std::uint64_t messages_sent_ = 0;               // by the process, when the last wait began
  std::chrono::nanoseconds usual_ = 4 * longest;  // a moving average, so that a long wait ends busy waits
  int failures_ = 0;                              // busy waits in a row without the event
  int pause_left_ = 0;                            // waits that sleep in any case
};

}  // namespace tfloom
