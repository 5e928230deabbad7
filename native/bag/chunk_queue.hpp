// Messages of a recording, gathered into chunks of MCAP message records on the threads that receive them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/sink.hpp"

namespace tfloom::bag {

// A sequence of MCAP message records, and where each channel's are.
struct Chunk {
  struct Entry {
    std::int64_t log_time = 0;  // [ns since epoch]
    std::uint64_t offset = 0;   // of the record in `records`
  };

  std::vector<std::byte> records;
  std::vector<std::vector<Entry>> index;  // by channel
  std::int64_t start = 0;                 // smallest and greatest log time
  std::int64_t end = 0;
  std::uint64_t message_count = 0;
  bool starts_file = false;  // it is the first one of a new file

  void append(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time,
              std::int64_t publish_time);
};

// Any thread pushes, one takes. Its memory is bounded by `cache_size`: what exceeds it is dropped and counted, or, in a
// ring, takes the place of the oldest chunk.
class ChunkQueue {
 public:
  struct Limits {
    std::size_t chunk_size = 0;    // a chunk is complete when its records have at least this size
    std::size_t cache_size = 0;    // of all records that are not taken
    std::int64_t duration_ns = 0;  // a message later than this after the first one of a file ends the file; 0: none does
    bool is_ring = false;
  };

  explicit ChunkQueue(const Limits& limits) : limits_(limits) {}

  // Append a message; return whether it was stored. It is not while the queue is paused, closed or full.
  bool push(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time, std::int64_t publish_time);

  // As `push`, with the time of receipt as log time, or with the simulated time.
  void receive(std::uint16_t channel, std::span<const std::byte> data, const SampleInfo& info);

  // Remove and return the oldest complete chunk. Wait for one until the timeout, then complete the unfinished one.
  // Return nullptr if there is no message, or the queue is closed and empty.
  std::unique_ptr<Chunk> take(std::chrono::nanoseconds timeout);

  // Wait for a complete chunk or the end, until the timeout.
  void wait(std::chrono::nanoseconds timeout);

  void seal();          // complete the unfinished chunk
  void end_file();      // the same, and let the next message be the first one of a new file
  void restart_file();  // let the next message be the first one, as far as `duration_ns` is concerned
  void close();         // store nothing more; `take` returns what is left, and does not wait

  void set_paused(bool is_paused);
  // Set the log time of all messages [ns since epoch]; 0: unknown, nothing is stored; empty: the time of receipt.
  void set_simulated_time(std::optional<std::int64_t> now_ns);

  [[nodiscard]] bool has_chunk() const;  // whether a complete chunk is waiting
  [[nodiscard]] std::uint64_t message_count() const;
  [[nodiscard]] std::uint64_t dropped_count() const;
  [[nodiscard]] std::vector<std::uint64_t> dropped_counts() const;  // by channel, as far as one has lost a message
  [[nodiscard]] std::size_t size() const;  // of all records that are not taken

 private:
  bool store(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time, std::int64_t publish_time);
  bool make_room(std::size_t size);
  void count_dropped(std::uint16_t channel);
  void complete();
  void start_file();

  const Limits limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::unique_ptr<Chunk>> complete_;  // guarded by mutex_, like all below
  std::unique_ptr<Chunk> unfinished_;
  std::size_t size_ = 0;
  std::optional<std::int64_t> file_start_;
  bool next_starts_file_ = false;
  std::optional<std::int64_t> simulated_now_;
  bool is_paused_ = false;
  bool is_closed_ = false;
  std::uint64_t message_count_ = 0;
  std::vector<std::uint64_t> dropped_counts_;  // by channel
};

// The sink of one topic.
class ChunkSink : public Sink {
 public:
  ChunkSink(std::shared_ptr<ChunkQueue> queue, std::uint16_t channel) : queue_(std::move(queue)), channel_(channel) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

 private:
  const std::shared_ptr<ChunkQueue> queue_;
  const std::uint16_t channel_;
};

}  // namespace tfloom::bag
