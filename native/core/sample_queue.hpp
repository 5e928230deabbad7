// A sink that stores samples until they are taken.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "core/sink.hpp"

namespace tfloom {

class SampleQueue : public Sink {
 public:
  struct Sample {
    std::vector<std::byte> data;
    SampleInfo info;
  };

  explicit SampleQueue(std::size_t depth) : depth_(depth) {}

  // Store a copy. In a full queue, it replaces the oldest sample.
  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  [[nodiscard]] std::deque<Sample> take();     // remove all samples, oldest first
  [[nodiscard]] std::uint64_t pushed() const;  // number of samples pushed since construction

 private:
  void keep(std::span<const std::byte> data, const SampleInfo& info);

  mutable std::mutex mutex_;
  const std::size_t depth_;
  std::deque<Sample> samples_;  // guarded by mutex_, like the next
  std::uint64_t pushed_ = 0;
};

}  // namespace tfloom
