// Threads that push messages of a recording while another takes chunks. Returns 0 if every message was taken once, in the
// order of its thread, or counted as dropped; the sanitizer checks the rest.
#include <atomic>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "bag/chunk_queue.hpp"
#include "checks.hpp"

using tfloom::bag::Chunk;
using tfloom::bag::ChunkQueue;
using tfloom::bag::ChunkSink;

namespace {

constexpr int pushers = 4;
constexpr std::uint64_t messages = 20'000;

// Return how many messages were taken; check that those of each channel are in order.
std::uint64_t run(const ChunkQueue::Limits& limits) {
  const auto queue = std::make_shared<ChunkQueue>(limits);
  std::atomic<int> pushing{pushers};
  std::vector<std::thread> threads;
  for (int number = 0; number < pushers; ++number) {
    threads.emplace_back([&queue, &pushing, number] {
      ChunkSink sink(queue, static_cast<std::uint16_t>(number));
      for (std::uint64_t message = 1; message <= messages; ++message) {
        std::byte data[8];
        std::memcpy(data, &message, sizeof(message));
        sink.push(data, {static_cast<std::int64_t>(message), static_cast<std::int64_t>(message), {}});
        if (message % 5'000 == 0) queue->end_file();
      }
      if (--pushing == 0) queue->close();
    });
  }
  std::uint64_t taken = 0;
  std::int64_t last[pushers] = {};
  while (const std::unique_ptr<Chunk> chunk = queue->take(std::chrono::seconds(20))) {
    taken += chunk->message_count;
    for (std::size_t channel = 0; channel < chunk->index.size(); ++channel) {
      for (const Chunk::Entry& entry : chunk->index[channel]) {
        check(entry.log_time > last[channel], "a channel's messages are out of order");
        check(entry.offset + 39 <= chunk->records.size(), "an entry points outside of the chunk");
        last[channel] = entry.log_time;
      }
    }
  }
  for (auto& thread : threads) thread.join();
  check(queue->size() == 0, "the queue is not empty");
  check(limits.is_ring || queue->message_count() == taken, "messages were lost");
  check(queue->message_count() + queue->dropped_count() == pushers * messages, "messages were not counted");
  return taken;
}

}  // namespace

int main() {
  check(run({4'096, std::size_t{1} << 30, 0, false}) == pushers * messages, "not all messages were taken");
  check(run({4'096, 20'000, 0, false}) > 0, "nothing was taken from a full queue");
  check(run({1'024, 20'000, 0, true}) > 0, "nothing was taken from a ring");
  check(run({4'096, std::size_t{1} << 30, 100, false}) == pushers * messages, "not all messages were taken from files");
  return faults == 0 ? 0 : 1;
}
