#include "core/ready_queue.hpp"

#include <algorithm>
#include <utility>

namespace tfloom {

void ReadyQueue::post(Token token) {
  {
    const std::lock_guard lock(mutex_);
    if (!pending_.insert(token).second) return;
    order_.push_back(token);
    has_tokens_.store(true, std::memory_order_release);
    // A busy executor takes the tokens before it waits, so it needs no wake-up. With a wake-up for each token, a post
    // takes 3.5 times as long: benchmarks/native, "wake-up if waiting".
    if (!std::exchange(is_waiting_, false)) return;
  }
  waker_.wake();  // without the lock, which the woken thread needs first of all
}

void ReadyQueue::post_quietly(Token token) {
  {
    const std::lock_guard lock(mutex_);
    if (std::ranges::find(quiet_, token) != quiet_.end()) return;
    quiet_.push_back(token);
    if (!is_quiet_wanted_) return;  // the token stays until a wait takes quiet ones
    has_tokens_.store(true, std::memory_order_release);
    if (!std::exchange(is_waiting_, false)) return;
  }
  waker_.wake();
}

void ReadyQueue::withdraw(Token token) {
  const std::lock_guard lock(mutex_);
  std::erase(quiet_, token);
}

bool ReadyQueue::take(std::vector<Token>& tokens, bool quiet) { return take(tokens, quiet, false); }

bool ReadyQueue::take(std::vector<Token>& tokens, bool quiet, bool will_sleep) {
  const std::lock_guard lock(mutex_);
  tokens.clear();
  tokens.swap(order_);
  pending_.clear();
  has_tokens_.store(false, std::memory_order_relaxed);
  is_quiet_wanted_ = quiet;
  if (quiet) {
    tokens.insert(tokens.end(), quiet_.begin(), quiet_.end());
    quiet_.clear();
  }
  // Set under the lock under which the tokens were found missing: a post before it is in `tokens`, and a post after it
  // sees the flag and wakes this thread. So no wake-up is lost between the look and the sleep.
  is_waiting_ = will_sleep && tokens.empty();
  return !tokens.empty();
}

ReadyQueue::Outcome ReadyQueue::wait(std::int64_t timeout_ns, std::vector<Token>& tokens, bool quiet,
                                     int interrupt_fd) {
  // Three steps, from cheap to expensive: what is there; a busy wait, if a reply is likely to come soon; a sleep.
  if (take(tokens, quiet)) return Outcome::ready;
  const auto begin = std::chrono::steady_clock::now();
  const Waker::Deadline deadline(timeout_ns);
  // With a sleep in each wait, a round trip takes up to three times as long: benchmarks/native, "busy wait".
  const bool is_ready = busy_wait_.wait(has_tokens_, deadline.left()) && take(tokens, quiet);
  const Outcome outcome = is_ready ? Outcome::ready : sleep(deadline, tokens, quiet, interrupt_fd);
  busy_wait_.learn(std::chrono::steady_clock::now() - begin);
  return outcome;
}

ReadyQueue::Outcome ReadyQueue::sleep(const Waker::Deadline& deadline, std::vector<Token>& tokens, bool quiet,
                                      int interrupt_fd) {
  // A wake-up need not mean a token: it may be left from a wait that ended otherwise. Then look, and sleep again.
  while (!take(tokens, quiet, true)) {
    switch (waker_.wait(deadline, interrupt_fd)) {
      case Waker::Outcome::woken: break;
      // Once more, because a token may have come since; this also notes that no thread waits, so posts don't wake one.
      case Waker::Outcome::timeout: return take(tokens, quiet) ? Outcome::ready : Outcome::timeout;
      case Waker::Outcome::interrupted: return Outcome::interrupted;
    }
  }
  return Outcome::ready;
}

}  // namespace tfloom
