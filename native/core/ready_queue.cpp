#include "core/ready_queue.hpp"

namespace tfloom {

void ReadyQueue::post(Token token) {
  {
    const std::lock_guard lock(mutex_);
    if (!pending_.insert(token).second) return;
    order_.push_back(token);
    if (order_.size() > 1) return;  // the waiter has been woken for the first one
  }
  waker_.wake();
}

bool ReadyQueue::take(std::vector<Token>& tokens) {
  const std::lock_guard lock(mutex_);
  tokens.clear();
  tokens.swap(order_);
  pending_.clear();
  return !tokens.empty();
}

ReadyQueue::Outcome ReadyQueue::wait(std::int64_t timeout_ns, std::vector<Token>& tokens) {
  const Waker::Deadline deadline(timeout_ns);
  while (!take(tokens)) {
    switch (waker_.wait(deadline)) {
      case Waker::Outcome::woken: break;
      case Waker::Outcome::timeout: return take(tokens) ? Outcome::ready : Outcome::timeout;
      case Waker::Outcome::interrupted: return Outcome::interrupted;
    }
  }
  return Outcome::ready;
}

}  // namespace tfloom
