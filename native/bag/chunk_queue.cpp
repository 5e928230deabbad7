#include "bag/chunk_queue.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <numeric>
#include <utility>

#include "bag/mcap_records.hpp"

namespace tfloom::bag {
namespace {

constexpr std::size_t fields_size = 22;  // channel, sequence, log time, publish time
constexpr std::size_t max_reserved = 1 << 20;

// Write an integer in little-endian order, and return where the next one goes.
template <typename Integer>
std::byte* write_integer(std::byte* place, Integer value) {
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    *place++ = static_cast<std::byte>(static_cast<std::uint64_t>(value) >> (8 * i));
  }
  return place;
}

}  // namespace

void Chunk::append(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time,
                   std::int64_t publish_time) {
  if (index.size() <= channel) index.resize(channel + std::size_t{1});
  std::array<std::byte, record_header_size + fields_size> head;
  std::byte* place = write_integer(head.data(), static_cast<std::uint8_t>(Opcode::message));
  place = write_integer(place, static_cast<std::uint64_t>(fields_size + data.size()));
  place = write_integer(place, channel);
  place = write_integer(place, std::uint32_t{0});  // no sequence number, as rosbag2 writes
  place = write_integer(place, log_time);
  write_integer(place, publish_time);
  const std::size_t offset = records.size();
  const std::size_t size = offset + head.size() + data.size();
  // Doubled, because `reserve` makes room for exactly the requested size.
  if (size > records.capacity()) records.reserve(std::max(size, 2 * records.capacity()));
  index[channel].push_back({log_time, offset});
  records.insert(records.end(), head.begin(), head.end());
  records.insert(records.end(), data.begin(), data.end());
  start = message_count == 0 ? log_time : std::min(start, log_time);
  end = message_count == 0 ? log_time : std::max(end, log_time);
  ++message_count;
}

bool ChunkQueue::push(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time,
                      std::int64_t publish_time) {
  const std::lock_guard lock(mutex_);
  if (is_paused_ || is_closed_) return false;
  return store(channel, data, log_time, publish_time);
}

void ChunkQueue::receive(std::uint16_t channel, std::span<const std::byte> data, const SampleInfo& info) {
  const std::lock_guard lock(mutex_);
  if (is_paused_ || is_closed_ || simulated_now_ == 0) return;
  store(channel, data, simulated_now_.value_or(info.received_stamp_ns), info.source_stamp_ns);
}

bool ChunkQueue::store(std::uint16_t channel, std::span<const std::byte> data, std::int64_t log_time,
                       std::int64_t publish_time) {
  // First the room, so that a message that is dropped neither starts a file nor counts for its duration.
  const std::size_t record_size = record_header_size + fields_size + data.size();
  if (!make_room(record_size)) {
    count_dropped(channel);
    return false;
  }
  if (limits_.duration_ns > 0 && file_start_ && log_time - *file_start_ > limits_.duration_ns) start_file();
  if (!unfinished_) {
    unfinished_ = std::make_unique<Chunk>();
    unfinished_->starts_file = std::exchange(next_starts_file_, false);
    unfinished_->records.reserve(std::min(limits_.chunk_size, max_reserved) + record_size);
  }
  unfinished_->append(channel, data, log_time, publish_time);
  if (!file_start_) file_start_ = log_time;
  size_ += record_size;
  ++message_count_;
  if (unfinished_->records.size() >= limits_.chunk_size) complete();
  return true;
}

bool ChunkQueue::make_room(std::size_t size) {
  // An empty queue takes a message of any size; otherwise one that is larger than the cache could never be recorded.
  if (!limits_.is_ring) return size_ == 0 || size_ + size <= limits_.cache_size;
  // A ring gives up whole chunks, because their records and indexes belong together. The unfinished one is never given
  // up, so the cache may exceed its limit by that.
  while (size_ + size > limits_.cache_size && !complete_.empty()) {
    size_ -= complete_.front()->records.size();
    complete_.pop_front();
  }
  return true;
}

void ChunkQueue::count_dropped(std::uint16_t channel) {
  if (dropped_counts_.size() <= channel) dropped_counts_.resize(channel + std::size_t{1});
  ++dropped_counts_[channel];
}

void ChunkQueue::complete() {
  if (!unfinished_) return;
  complete_.push_back(std::move(unfinished_));
  changed_.notify_one();
}

// The first chunk of the new file bears the mark, not the last one of the file before: that one may have been taken.
void ChunkQueue::start_file() {
  complete();
  file_start_.reset();
  next_starts_file_ = true;
}

std::unique_ptr<Chunk> ChunkQueue::take(std::chrono::nanoseconds timeout) {
  // The wait is for a complete chunk. After the timeout the unfinished one is taken, however small, so that messages
  // that come slowly are written too.
  std::unique_lock lock(mutex_);
  if (complete_.empty() && !is_closed_ && timeout.count() > 0) {
    changed_.wait_for(lock, timeout, [this] { return !complete_.empty() || is_closed_; });
  }
  if (complete_.empty()) complete();
  if (complete_.empty()) return nullptr;
  std::unique_ptr<Chunk> oldest = std::move(complete_.front());
  complete_.pop_front();
  size_ -= oldest->records.size();
  return oldest;
}

void ChunkQueue::wait(std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return !complete_.empty() || is_closed_; });
}

void ChunkQueue::seal() {
  const std::lock_guard lock(mutex_);
  complete();
}

void ChunkQueue::end_file() {
  const std::lock_guard lock(mutex_);
  start_file();
}

void ChunkQueue::restart_file() {
  const std::lock_guard lock(mutex_);
  file_start_.reset();
}

void ChunkQueue::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

void ChunkQueue::set_paused(bool is_paused) {
  const std::lock_guard lock(mutex_);
  is_paused_ = is_paused;
}

void ChunkQueue::set_simulated_time(std::optional<std::int64_t> now_ns) {
  const std::lock_guard lock(mutex_);
  simulated_now_ = now_ns;
}

bool ChunkQueue::has_chunk() const {
  const std::lock_guard lock(mutex_);
  return !complete_.empty();
}

std::uint64_t ChunkQueue::message_count() const {
  const std::lock_guard lock(mutex_);
  return message_count_;
}

std::uint64_t ChunkQueue::dropped_count() const {
  const std::lock_guard lock(mutex_);
  return std::accumulate(dropped_counts_.begin(), dropped_counts_.end(), std::uint64_t{0});
}

std::vector<std::uint64_t> ChunkQueue::dropped_counts() const {
  const std::lock_guard lock(mutex_);
  return dropped_counts_;
}

std::size_t ChunkQueue::size() const {
  const std::lock_guard lock(mutex_);
  return size_;
}

void ChunkSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  try {
    queue_->receive(channel_, data, info);
    signal_push();
  } catch (const std::bad_alloc&) {  // the message is lost, as in a full cache
  }
}

}  // namespace tfloom::bag
