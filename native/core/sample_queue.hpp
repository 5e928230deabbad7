// A sink that keeps what it is fed until somebody takes it.
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

  // Keeps a copy; the oldest one makes room.
  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  [[nodiscard]] std::deque<Sample> take();
  [[nodiscard]] std::uint64_t pushed() const;

 private:
  mutable std::mutex mutex_;
  const std::size_t depth_;
  std::deque<Sample> samples_;  // guarded by mutex_, as is the next
  std::uint64_t pushed_ = 0;
};

}  // namespace tfloom
