// The sending end of a topic: bytes in, samples on the wire.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <shared_mutex>
#include <span>
#include <vector>

#include "dds/endpoint.hpp"
#include "dds/events.hpp"
#include "dds/peers.hpp"
#include "dds/qos.hpp"

namespace tfloom::dds {

class Writer {
 public:
  Writer(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Sends one sample: the encapsulation header of little-endian CDR, then the CDR. From any thread; may wait for slow
  // readers of a reliable topic. Throws std::invalid_argument for another header, Error once closed.
  void write(std::span<const std::byte> data);

  [[nodiscard]] std::size_t matched_count() const;
  [[nodiscard]] std::vector<Peer> matched();
  [[nodiscard]] const Gid& gid() const { return gid_; }

  void notify_event(Event event, ReadyQueue* queue, ReadyQueue::Token token);
  [[nodiscard]] std::optional<Events::Status> take_event(Event event);

  // Tells readers that this writer is alive, as a write does.
  void assert_liveliness();

  // Waits until all matched reliable readers have all that was written; false on a timeout.
  [[nodiscard]] bool wait_for_acks(std::int64_t timeout_ns);

  // Leaves the topic, when the writes under way have ended; a write that waits for readers ends at once.
  void close();

 private:
  Participant& participant_;
  const Library& library_;
  Entity topic_;  // constant once constructed, as are the next three
  Entity entity_ = 0;
  const Sertype_* type_ = nullptr;  // valid until topic_ is deleted, with in_use_ held alone
  Gid gid_{};
  Events events_;  // locks itself, as does the next
  Peers peers_;
  std::atomic<bool> closed_ = false;
  std::shared_mutex in_use_;  // shared by writes, which use type_; alone for the deletion of topic_
};

}  // namespace tfloom::dds
