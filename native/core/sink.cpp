#include "core/sink.hpp"

#include <utility>

namespace tfloom {

void Sink::notify(ReadyQueue::Shared queue, ReadyQueue::Token token) {
  const std::lock_guard lock(mutex_);
  // A token that has not been taken would wake the former queue for a sink that no longer posts to it.
  if (queue_ != nullptr) queue_->withdraw(token_);
  queue_ = std::move(queue);
  token_ = token;
  if (queue_ != nullptr && is_pushed_) queue_->post_quietly(token);
}

void Sink::signal_push() {
  // One token stands for all pushes until they are taken, so most pushes need no lock.
  if (is_pushed_.exchange(true)) return;
  const std::lock_guard lock(mutex_);
  if (queue_ != nullptr) queue_->post_quietly(token_);
}

}  // namespace tfloom
