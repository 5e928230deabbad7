// A reader of a topic. Its samples are taken one by one, or fed to a sink.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
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
#include "rtps/service_forms.hpp"

namespace tfloom::dds {

class Reader {
 public:
  using Receive = std::function<void(std::span<const std::byte> data, const SampleInfo& info)>;

  Reader(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  // Post `token` when there are samples to take, at once if there may be some now; nullptr ends this.
  void notify(ReadyQueue::Shared queue, ReadyQueue::Token token);

  // Remove the oldest sample and pass it to `receive`. Return false if there is none, or if a sink is fed.
  bool take(const Receive& receive);

  // Take as an end of a service from now on: samples in the inline form of services get a header, and those for other
  // ends are dropped. To be called before the first take.
  void join(std::shared_ptr<rtps::ServiceEnd> end) { service_end_ = std::move(end); }

  // Push every further sample into `sink`, on the library's threads or the feeder's. The reader shares it until another
  // one is fed or the reader is closed.
  void feed(std::shared_ptr<Sink> sink);

  // Tell writers which samples are wanted, as far as they can filter: all are taken that arrive. An empty expression accepts
  // all. Do nothing after `close`.
  void announce_filter(const std::string& expression, const std::vector<std::string>& parameters);

  [[nodiscard]] std::size_t matched_count() const;
  [[nodiscard]] std::vector<Peer> matched();
  [[nodiscard]] const Gid& gid() const { return gid_; }

  void notify_event(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token);
  [[nodiscard]] std::optional<Events::Status> take_event(Event event);

  // Leave the topic. After it has returned, neither queue nor sink is used.
  void close();

 private:
  // Pass a sample of the inline form of services to `receive`, with a header. Return false if it is for another end.
  bool receive_inline(std::span<const std::byte> data, const SampleInfo& info, const Receive& receive);
  static void on_data_available(Entity, void* self);
  void data_available();
  void matches_changed();
  void update_publishers();  // requires feed_mutex_ to be held
  [[nodiscard]] bool has_data() const;
  bool drain();
  void feed_from_listener();
  bool push_batch();  // requires feed_mutex_ to be held; true: there may be more samples

  Participant& participant_;
  const Library& library_;
  OwnedEntity topic_;  // constant after construction, like the next two
  OwnedEntity entity_;
  Gid gid_;
  const std::string topic_name_;
  const std::string user_data_;
  int announcements_ = 0;  // of filters; guarded by lifecycle_mutex_
  Events events_;  // thread-safe by itself, like the next
  Peers peers_;
  std::shared_ptr<rtps::ServiceEnd> service_end_;  // constant after the first take; thread-safe by itself
  Feeder::Task drain_task_;
  std::atomic<bool> closed_ = false;
  std::atomic<bool> has_new_match_ = false;
  std::atomic<bool> may_have_data_ = false;  // false: there are no samples to take
  std::atomic<Sink*> sink_ = nullptr;        // written with feed_mutex_ held
  std::mutex feed_mutex_;                    // held by the thread that feeds; a listener acquires it by try_lock only
  std::vector<Gid> publishers_;              // guarded by feed_mutex_: those at the last change of the matches
  std::mutex lifecycle_mutex_;               // held during `feed`, `announce_filter` and `close`
  std::shared_ptr<Sink> shared_sink_;        // what sink_ points to; guarded by lifecycle_mutex_
  std::mutex listener_mutex_;                // acquired in the listener, so it is held for short sections only
  ReadyQueue::Shared queue_;                 // guarded by listener_mutex_, like the next
  ReadyQueue::Token token_ = 0;
};

}  // namespace tfloom::dds
