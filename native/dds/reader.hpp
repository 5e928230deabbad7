// The receiving end of a topic: samples off the wire, for Python to take or fed to a sink.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/ready_queue.hpp"
#include "core/sink.hpp"
#include "dds/endpoint.hpp"
#include "dds/events.hpp"
#include "dds/feeder.hpp"
#include "dds/peers.hpp"
#include "dds/qos.hpp"

namespace tfloom::dds {

class Reader : private Feeder::Source {
 public:
  using Receive = std::function<void(std::span<const std::byte> data, const SampleInfo& info)>;

  Reader(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data);
  ~Reader() override;

  // Posts `token` when there is something to take, at once if there may be; nullptr ends it.
  void notify(ReadyQueue* queue, ReadyQueue::Token token);

  // Hands the oldest waiting sample to `receive` and removes it; false if there is none, or the reader is fed.
  bool take(const Receive& receive);

  // From now on pushes every sample into `sink`, on the library's threads or the feeder's.
  void feed(Sink* sink);

  [[nodiscard]] std::size_t matched_count() const;
  [[nodiscard]] std::vector<Peer> matched();
  [[nodiscard]] const Gid& gid() const { return gid_; }

  void notify_event(Event event, ReadyQueue* queue, ReadyQueue::Token token);
  [[nodiscard]] std::optional<Events::Status> take_event(Event event);

  // Leaves the topic; when it returns, neither queue nor sink will be touched again.
  void close();

 private:
  static void on_data_available(Entity, void* self);
  void data_available();
  void matches_changed();
  bool drain() override;
  void feed_here();
  bool push_some();  // with feed_mutex_ held; true if there may be more

  Participant& participant_;
  const Library& library_;
  Entity topic_;  // constant once constructed, as are the next two
  Entity entity_ = 0;
  Gid gid_{};
  Events events_;  // locks itself, as does the next
  Peers peers_;
  std::atomic<bool> closed_ = false;
  std::atomic<bool> is_match_new_ = false;
  std::atomic<bool> is_data_new_ = false;  // false: nothing waits to be taken
  std::atomic<Sink*> sink_ = nullptr;  // written with feed_mutex_ held
  std::mutex feed_mutex_;              // for one thread at a time that feeds; a listener only tries it
  std::mutex lifecycle_mutex_;         // for one feed or close at a time
  std::mutex listener_mutex_;          // taken by the listener, so it is held for moments only
  ReadyQueue* queue_ = nullptr;        // guarded by listener_mutex_, as is the next
  ReadyQueue::Token token_ = 0;
};

}  // namespace tfloom::dds
