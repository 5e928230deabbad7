// Statistics of all transforms on /tf and /tf_static, by publisher and edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/sink.hpp"
#include "tf2/buffer.hpp"
#include "tf2/edge_statistics.hpp"
#include "tf2/name_index.hpp"

namespace tfloom::cdr {

// What one publisher has sent on one of the two topics. Times of receipt are [ns since epoch].
struct TfTraffic {
  Gid gid{};
  bool is_static = false;  // whether it publishes on /tf_static
  bool has_left = false;
  std::uint64_t messages = 0, transforms = 0, bytes = 0;  // `bytes` with the encapsulation header
  std::uint64_t unreadable = 0;  // messages that are not a TFMessage
  std::uint64_t max_transforms = 0;  // in one message
  tf2::Stamp first_received = 0, last_received = 0;
  tf2::Spread period;   // between receipts of its messages [s]
  tf2::Spread transit;  // from writing, by the publisher's clock, to receipt, by ours [s]
};

// One edge of one publisher.
struct TfEdge {
  std::string child, parent;
  Gid gid{};
  bool is_static = false;
  tf2::EdgeStatistics statistics;
};

// A frame that was a child, on either topic and from any publisher.
struct TfChild {
  std::string child, parent;  // the last one
  std::uint64_t reparented = 0;  // transforms whose parent was another than that of the child's former one
  tf2::Stamp newest_stamp = 0;   // of its moving transforms
};

struct TfSnapshot {
  std::vector<TfTraffic> publishers;
  std::vector<TfEdge> edges;
  std::vector<TfChild> children;  // each list is in order of first receipt
  std::uint64_t unrecorded = 0;   // transforms beyond the observer's limits
};

// Thread-safe. Its memory is bounded: see the constants.
class TfObserver {
 public:
  static constexpr std::size_t max_publishers = 4096;
  static constexpr std::size_t max_edges = 65536;
  static constexpr std::size_t max_name_size = 1024;  // [bytes]

  explicit TfObserver(tf2::Stamp cache_time = tf2::Buffer::default_cache_time) : cache_time_(cache_time) {}
  TfObserver(const TfObserver&) = delete;
  TfObserver& operator=(const TfObserver&) = delete;

  // Record a message of `size` bytes that has these transforms, or that was not readable, and then has none.
  void record(std::span<const tf2::Entry> entries, const SampleInfo& info, bool is_static, std::size_t size,
              bool is_readable);
  void mark_left(const Gid& publisher, bool is_static);

  // Set the simulated time, with which stamps are compared; 0: it has not been received, and delays are not recorded.
  // nullopt: stamps are compared with the time of receipt.
  void set_simulated_time(std::optional<tf2::Stamp> now);
  [[nodiscard]] std::optional<tf2::Stamp> simulated_time() const;
  void clear();

  [[nodiscard]] TfSnapshot snapshot() const;

 private:
  using Id = std::uint32_t;
  struct EdgeKey {
    Id publisher, child, parent;
    bool operator==(const EdgeKey&) const = default;
  };
  struct EdgeHash {
    std::size_t operator()(const EdgeKey& key) const {
      const std::uint64_t names = (std::uint64_t{key.child} << 32) | key.parent;
      const std::uint64_t mixed = (names ^ (std::uint64_t{key.publisher} << 16)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(mixed ^ (mixed >> 29));
    }
  };
  struct Edge {
    EdgeKey key{};
    tf2::EdgeStatistics statistics;
  };
  struct Child {
    Id parent = tf2::NameIndex::none;  // none: it was no child yet
    std::uint64_t reparented = 0;
    tf2::Stamp newest_stamp = 0;
  };
  using PublisherKey = std::pair<Gid, bool>;

  // All require mutex_ to be held:
  std::optional<Id> find_publisher(const Gid& gid, bool is_static);
  [[nodiscard]] Id find_name(std::string_view name) const;  // NameIndex::none: unknown
  Id intern(std::string_view name);
  Edge* find_edge(Id publisher, const tf2::Entry& entry);
  void add(Id publisher, const tf2::Entry& entry, tf2::Stamp received, tf2::Stamp now);
  void drop_left();

  const tf2::Stamp cache_time_;
  mutable std::mutex mutex_;  // guards all that follows
  std::vector<TfTraffic> publishers_;
  std::map<PublisherKey, Id> publisher_ids_;
  std::vector<std::string> names_;
  std::vector<Child> children_;  // by the id of the name
  tf2::NameIndex name_ids_;
  std::vector<Edge> edges_;
  std::unordered_map<EdgeKey, Id, EdgeHash> edge_ids_;
  std::uint64_t unrecorded_ = 0;
  std::optional<tf2::Stamp> simulated_time_;
};

// Passes the samples of one topic to an observer, and to a buffer if there is one. The buffer's authority of a transform
// is the publisher's gid in hexadecimal.
class TfObserverSink final : public Sink {
 public:
  TfObserverSink(std::shared_ptr<TfObserver> observer, bool is_static, std::shared_ptr<tf2::Buffer> buffer)
      : observer_(std::move(observer)), is_static_(is_static), buffer_(std::move(buffer)) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;
  void forget(const Gid& publisher) override { observer_->mark_left(publisher, is_static_); }

  // Ignore the samples of all other publishers; nullopt: of none.
  void accept_only(std::optional<std::vector<Gid>> publishers);

 private:
  [[nodiscard]] bool accepts(const Gid& publisher) const;

  const std::shared_ptr<TfObserver> observer_;  // thread-safe by itself
  const bool is_static_;
  const std::shared_ptr<tf2::Buffer> buffer_;  // thread-safe by itself; null: none
  mutable std::mutex mutex_;
  std::optional<std::vector<Gid>> accepted_;  // guarded by mutex_
};

// Passes the time on /clock to an observer, as the simulated one.
class TfClockSink final : public Sink {
 public:
  explicit TfClockSink(std::shared_ptr<TfObserver> observer) : observer_(std::move(observer)) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

 private:
  const std::shared_ptr<TfObserver> observer_;  // thread-safe by itself
};

}  // namespace tfloom::cdr
