// What happens to an endpoint besides data: the statuses of DDS, posted to a queue and taken as counts.
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

class Events {
 public:
  // Up to four numbers, in the order of the fields of the event's status in tfloom.rmw.events; a policy by DDS's id.
  using Status = std::array<std::int64_t, 4>;

  // `on_match` is called by the listener whenever a peer connects or leaves.
  Events(const Library& library, bool of_writer, std::function<void()> on_match = {})
      : library_(library), of_writer_(of_writer), on_match_(std::move(on_match)) {}

  // Adds the callbacks to the listener that its endpoint is created with.
  void listen(Listener_* listener);

  // Posts `token` when `event` may have news, once at the start too; nullptr ends it.
  // Throws std::invalid_argument for an event of the other kind of endpoint, as does `take`.
  void notify(Event event, ReadyQueue* queue, ReadyQueue::Token token);

  // Returns the status of `entity`, with the changes since the last call; empty if nothing has changed.
  std::optional<Status> take(Event event, Entity entity);

  // Forgets the queues.
  void close();

 private:
  static constexpr std::size_t event_count = 6;
  struct Watcher {
    ReadyQueue* queue = nullptr;
    ReadyQueue::Token token = 0;
  };

  template <Event event, typename StatusOf>
  static void on_event(Entity, StatusOf, void* self);
  void post(Event event);
  void check(Event event) const;
  Status read(Event event, Entity entity) const;

  const Library& library_;
  bool of_writer_;
  std::function<void()> on_match_;
  std::mutex mutex_;  // taken by the listener, so it is not held while the library is called
  std::array<Watcher, event_count> watchers_;  // guarded by mutex_
  std::mutex taken_mutex_;                     // held while the library is called
  std::array<Status, event_count> taken_{};    // guarded by taken_mutex_
};

}  // namespace tfloom::dds
