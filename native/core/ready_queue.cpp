#include "core/ready_queue.hpp"

#include <algorithm>
#include <utility>

namespace tfloom {

void ReadyQueue::post(Token token) {
  {
    const std::lock_guard lock(mutex_);
    if (!pending_.insert(token).second) return;
    order_.push_back(token);
    // A busy executor takes the tokens before it waits, so it needs no wake-up. With a wake-up for each token, a post
    // takes 3.5 times as long: benchmarks/native, "wake-up if waiting".
    if (!std::exchange(is_waiting_, false)) return;
  }
  waker_.wake();
}

void ReadyQueue::post_quietly(Token token) {
  {
    const std::lock_guard lock(mutex_);
    if (std::ranges::find(quiet_, token) != quiet_.end()) return;
    quiet_.push_back(token);
    if (!is_quiet_wanted_ || !std::exchange(is_waiting_, false)) return;
  }
  waker_.wake();
}

void ReadyQueue::withdraw(Token token) {
  const std::lock_guard lock(mutex_);
  std::erase(quiet_, token);
}

bool ReadyQueue::take(std::vector<Token>& tokens, bool quiet) {
  const std::lock_guard lock(mutex_);
  tokens.clear();
  tokens.swap(order_);
  pending_.clear();
  is_quiet_wanted_ = quiet;
  if (quiet) {
    tokens.insert(tokens.end(), quiet_.begin(), quiet_.end());
    quiet_.clear();
  }
  is_waiting_ = tokens.empty();
  return !tokens.empty();
}

ReadyQueue::Outcome ReadyQueue::wait(std::int64_t timeout_ns, std::vector<Token>& tokens, bool quiet,
                                     int interrupt_fd) {
  const Waker::Deadline deadline(timeout_ns);
  while (!take(tokens, quiet)) {
    switch (waker_.wait(deadline, interrupt_fd)) {
      case Waker::Outcome::woken: break;
      case Waker::Outcome::timeout: return take(tokens, quiet) ? Outcome::ready : Outcome::timeout;
      case Waker::Outcome::interrupted: return Outcome::interrupted;
    }
  }
  return Outcome::ready;
}

}  // namespace tfloom
