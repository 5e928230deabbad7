// A writer of a topic. It sends serialized samples.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <span>
#include <utility>
#include <vector>

#include "dds/endpoint.hpp"
#include "dds/events.hpp"
#include "dds/peers.hpp"
#include "dds/qos.hpp"
#include "rtps/service_forms.hpp"

namespace tfloom::dds {

class Writer {
 public:
  // Encapsulation header of little-endian CDR, then the CDR, in order; the first part has the header.
  using Parts = std::span<const std::span<const std::byte>>;

  // A sample that can be sent. As long as it exists, `close` waits for the thread that made it, which must send or delete it.
  class Sample;

  // `waits` is whether a write waits for readers that lag behind.
  Writer(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data,
         bool waits = true);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Send one sample: the encapsulation header of little-endian CDR, then the CDR. May be called from any thread; may
  // wait for slow readers of a reliable topic. Return false if they lag behind and this writer doesn't wait: then nothing
  // was sent. Throw std::invalid_argument for another header, and Error if the writer is closed.
  //
  // Writes of an end of a service that doesn't wait are made one at a time.
  bool write(std::span<const std::byte> data);

  // Copy the parts of a sample, and send it: both together are a `write`, for an end of no service. `make` doesn't wait for
  // readers. Both throw as `write`.
  [[nodiscard]] Sample make(Parts parts);
  bool send(Sample&& sample);

  [[nodiscard]] std::size_t matched_count() const;
  [[nodiscard]] std::vector<Peer> matched();
  [[nodiscard]] const Gid& gid() const { return gid_; }

  void notify_event(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token);
  [[nodiscard]] std::optional<Events::Status> take_event(Event event);

  // Send a message that readers acknowledge and drop: the end of an instance that does not exist.
  void probe();

  // Write as an end of a service from now on. To be called before the first write.
  void join(std::shared_ptr<rtps::ServiceEnd> end) { service_end_ = std::move(end); }

  // Signal to readers that this writer is alive, as a write does.
  void assert_liveliness();

  // Wait until all matched reliable readers have acknowledged all samples. Return false on a timeout.
  [[nodiscard]] bool wait_for_acks(std::int64_t timeout_ns);

  // Leave the topic after running writes have ended. A write that waits for readers ends at once.
  void close();

 private:
  // Keep a large sample until it is acknowledged, if a peer may receive it in fragments in the other form of services.
  // Return whether it was kept; nullopt if there is no room and this writer doesn't wait.
  std::optional<bool> keep(std::span<const std::byte> data, std::size_t padding);
  [[nodiscard]] Serdata_* make_serdata(Parts parts) const;

  Participant& participant_;
  const Library& library_;
  OwnedEntity topic_;  // constant after construction, like the next three
  OwnedEntity entity_;
  const Sertype_* type_;  // valid until topic_ is deleted, which requires in_use_ exclusively
  const bool waits_;
  Gid gid_;
  Events events_;  // thread-safe by itself, like the next
  Peers peers_;
  std::shared_ptr<rtps::ServiceEnd> service_end_;  // constant after the first write; thread-safe by itself
  std::atomic<bool> closed_ = false;
  std::shared_mutex in_use_;  // shared by writes, which use type_; exclusive for the deletion of topic_
};

class Writer::Sample {
 public:
  Sample(Sample&& other) noexcept
      : library_(other.library_), lock_(std::move(other.lock_)), serdata_(std::exchange(other.serdata_, nullptr)) {}
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;
  Sample& operator=(Sample&&) = delete;
  ~Sample() {
    if (serdata_ != nullptr) library_.serdata_unref(serdata_);
  }

 private:
  friend class Writer;
  Sample(const Library& library, std::shared_lock<std::shared_mutex> lock, Serdata_* serdata)
      : library_(library), lock_(std::move(lock)), serdata_(serdata) {}

  const Library& library_;
  std::shared_lock<std::shared_mutex> lock_;  // released after the serdata, whose type it protects
  Serdata_* serdata_;
};

}  // namespace tfloom::dds
