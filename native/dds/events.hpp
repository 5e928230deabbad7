// The status events of an endpoint in DDS: each is posted to a queue, and its status is taken as counts.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "core/ready_queue.hpp"
#include "dds/library.hpp"

namespace tfloom::dds {

// Numbered as in tfloom.rmw.events.
enum class Event { matched, incompatible_qos, deadline_missed, liveliness_lost, liveliness_changed, message_lost };
inline constexpr std::size_t event_count = static_cast<std::size_t>(Event::message_lost) + 1;  // of the last one

class Events {
 public:
  // Up to four numbers, in the order of the fields of the event's status in tfloom.rmw.events; a policy by DDS's id.
  using Status = std::array<std::int64_t, 4>;

  // The listener calls `on_match` whenever a peer is matched or unmatched.
  Events(const Library& library, bool of_writer, std::function<void()> on_match = {})
      : library_(library), of_writer_(of_writer), on_match_(std::move(on_match)) {}

  // Add the callbacks to the listener with which the endpoint will be created.
  void listen(Listener_* listener);

  // Post `token` to `queue` now, and whenever the status of `event` may have changed; nullptr ends this.
  // Throw std::invalid_argument for an event that this kind of endpoint does not have.
  void notify(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token);

  // Return the status of `entity`, with the changes since the last call; empty if it has not changed.
  // Throw std::invalid_argument as `notify` does.
  std::optional<Status> take(Event event, Entity entity);

  // Remove all queues.
  void close();

 private:
  struct Watcher {
    ReadyQueue::Shared queue;
    ReadyQueue::Token token = 0;
  };

  template <Event event, typename StatusOf>
  static void on_event(Entity, StatusOf, void* self);
  void post_to_watcher(Event event);
  void check(Event event) const;
  Status read(Event event, Entity entity) const;

  const Library& library_;
  bool of_writer_;
  std::function<void()> on_match_;
  std::mutex mutex_;  // acquired in the listener, so it is not held during calls of the library
  std::array<Watcher, event_count> watchers_;   // guarded by mutex_
  std::mutex reported_mutex_;                   // held during calls of the library
  std::array<Status, event_count> reported_{};  // totals at the last `take`; guarded by reported_mutex_
};

}  // namespace tfloom::dds
