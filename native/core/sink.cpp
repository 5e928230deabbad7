#include "core/sink.hpp"

namespace tfloom {

void Sink::notify(ReadyQueue* queue, ReadyQueue::Token token) {
  const std::lock_guard lock(mutex_);
  if (queue_ != nullptr) queue_->withdraw(token_);
  queue_ = queue;
  token_ = token;
  if (queue != nullptr && is_pushed_) queue->post_quietly(token);
}

void Sink::signal_push() {
  if (is_pushed_.exchange(true)) return;
  const std::lock_guard lock(mutex_);
  if (queue_ != nullptr) queue_->post_quietly(token_);
}

}  // namespace tfloom
