#include "core/sample_queue.hpp"

#include <new>
#include <utility>

namespace tfloom {

void SampleQueue::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  const std::lock_guard lock(mutex_);
  ++pushed_;
  if (depth_ == 0) return;
  try {
    samples_.push_back({{data.begin(), data.end()}, info});
  } catch (const std::bad_alloc&) {
    return;  // the sample is dropped, but counted
  }
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
