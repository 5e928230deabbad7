// The interface to which a wire passes serialized samples, on the wire's own threads and without Python.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>

#include "core/ready_queue.hpp"

namespace tfloom {

using Gid = std::array<std::uint8_t, 16>;

struct SampleInfo {
  std::int64_t source_stamp_ns = 0;    // writer's clock, since epoch
  std::int64_t received_stamp_ns = 0;  // our clock, since epoch
  Gid publisher_gid{};
};

class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;

  // Process one sample: the four bytes of encapsulation header, then CDR. `data` is untrusted and valid only during
  // the call. An unreadable sample is counted and dropped. The call must return within microseconds, because the thread
  // may be the one that receives all samples of the process; calls into Python are deferred
  // (core/deferred_queue.hpp).
  virtual void push(std::span<const std::byte> data, const SampleInfo& info) noexcept = 0;

  // Forget what is stored for a publisher that has left.
  virtual void forget(const Gid& /*publisher*/) {}

  // Post `token` quietly after a push, at once if there was one since `take_pushed`; nullptr ends it.
  void notify(ReadyQueue::Shared queue, ReadyQueue::Token token);

  // Return whether a sample was pushed since the last call.
  [[nodiscard]] bool take_pushed() { return is_pushed_.exchange(false); }

 protected:
  // Called by `push` once the effect of the sample is visible. Acquires no lock between two calls of `take_pushed`, but
  // for the first push.
  void signal_push();

 private:
  std::atomic<bool> is_pushed_ = false;
  std::mutex mutex_;
  ReadyQueue::Shared queue_;  // guarded by mutex_, like the next
  ReadyQueue::Token token_ = 0;
};

}  // namespace tfloom
