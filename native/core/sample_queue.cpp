#include "core/sample_queue.hpp"

#include <new>
#include <utility>

namespace tfloom {

void SampleQueue::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  try {
    keep(data, info);
    signal_push();
  } catch (const std::bad_alloc&) {  // the sample is dropped, but counted
  }
}

void SampleQueue::keep(std::span<const std::byte> data, const SampleInfo& info) {
  const std::lock_guard lock(mutex_);
  ++pushed_;
  if (depth_ == 0) return;
  samples_.push_back({{data.begin(), data.end()}, info});
  if (samples_.size() > depth_) samples_.pop_front();
}

std::deque<SampleQueue::Sample> SampleQueue::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(samples_, {});
}

std::uint64_t SampleQueue::pushed() const {
  const std::lock_guard lock(mutex_);
  return pushed_;
}

}  // namespace tfloom
