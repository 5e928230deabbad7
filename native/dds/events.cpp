#include "dds/events.hpp"

#include <stdexcept>

namespace tfloom::dds {
namespace {

std::size_t index_of(Event event) { return static_cast<std::size_t>(event); }

// Return whether writers, or readers, have an event; false for a number from Python that is none. Without a `default`,
// the compiler warns of an event that is missing here.
bool has_event(bool of_writer, Event event) {
  switch (event) {
    case Event::matched:
    case Event::incompatible_qos:
    case Event::deadline_missed: return true;
    case Event::liveliness_lost: return of_writer;
    case Event::liveliness_changed:
    case Event::message_lost: return !of_writer;
  }
  return false;
}

template <typename StatusOf>
StatusOf get(Result (*function)(Entity, StatusOf*), Entity entity) {
  StatusOf status{};
  function(entity, &status);
  return status;
}

}  // namespace

template <Event event, typename StatusOf>
void Events::on_event(Entity, StatusOf, void* self) {
  static_cast<Events*>(self)->post_to_watcher(event);
}

void Events::listen(Listener_* listener) {
  const Library& l = library_;
  if (of_writer_) {
    l.lset_publication_matched_arg(listener, &on_event<Event::matched, MatchedStatus>, this, false);
    l.lset_offered_incompatible_qos_arg(listener, &on_event<Event::incompatible_qos, IncompatibleStatus>, this, false);
    l.lset_offered_deadline_missed_arg(listener, &on_event<Event::deadline_missed, DeadlineStatus>, this, false);
    l.lset_liveliness_lost_arg(listener, &on_event<Event::liveliness_lost, LostStatus>, this, false);
    return;
  }
  l.lset_subscription_matched_arg(listener, &on_event<Event::matched, MatchedStatus>, this, false);
  l.lset_requested_incompatible_qos_arg(listener, &on_event<Event::incompatible_qos, IncompatibleStatus>, this, false);
  l.lset_requested_deadline_missed_arg(listener, &on_event<Event::deadline_missed, DeadlineStatus>, this, false);
  l.lset_liveliness_changed_arg(listener, &on_event<Event::liveliness_changed, LivelinessStatus>, this, false);
  l.lset_sample_lost_arg(listener, &on_event<Event::message_lost, LostStatus>, this, false);
}

void Events::post_to_watcher(Event event) {
  if (event == Event::matched && on_match_) on_match_();
  const std::lock_guard lock(mutex_);
  const Watcher& watcher = watchers_[index_of(event)];
  if (watcher.queue != nullptr) watcher.queue->post(watcher.token);
}

void Events::notify(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token) {
  check(event);
  const std::lock_guard lock(mutex_);
  if (queue != nullptr) queue->post(token);
  watchers_[index_of(event)] = {std::move(queue), token};
}

void Events::check(Event event) const {
  if (has_event(of_writer_, event)) return;
  throw std::invalid_argument(of_writer_ ? "writers have no such event" : "readers have no such event");
}

// The library resets its own counts of changes with each call of a listener, so changes are computed from its totals.
std::optional<Events::Status> Events::take(Event event, Entity entity) {
  check(event);
  const std::lock_guard lock(reported_mutex_);
  const Status now = read(event, entity);
  Status& before = reported_[index_of(event)];
  if (now == before) return std::nullopt;
  const Status change{now[0] - before[0], now[1] - before[1], 0, 0};
  before = now;
  switch (event) {
    case Event::matched: return Status{now[0], change[0], now[1], change[1]};
    case Event::liveliness_changed: return Status{now[0], now[1], change[0], change[1]};
    case Event::incompatible_qos: return Status{now[0], change[0], now[2], 0};
    default: return Status{now[0], change[0], 0, 0};
  }
}

Events::Status Events::read(Event event, Entity entity) const {
  const Library& l = library_;
  switch (event) {
    case Event::matched: {
      const auto s = get(of_writer_ ? l.get_publication_matched_status : l.get_subscription_matched_status, entity);
      return {s.total_count, s.current_count, 0, 0};
    }
    case Event::incompatible_qos: {
      const auto s =
          get(of_writer_ ? l.get_offered_incompatible_qos_status : l.get_requested_incompatible_qos_status, entity);
      return {s.total_count, 0, s.last_policy_id, 0};
    }
    case Event::deadline_missed: {
      const auto s =
          get(of_writer_ ? l.get_offered_deadline_missed_status : l.get_requested_deadline_missed_status, entity);
      return {s.total_count, 0, 0, 0};
    }
    case Event::liveliness_lost: return {get(l.get_liveliness_lost_status, entity).total_count, 0, 0, 0};
    case Event::liveliness_changed: {
      const auto s = get(l.get_liveliness_changed_status, entity);
      return {s.alive_count, s.not_alive_count, 0, 0};
    }
    case Event::message_lost: return {get(l.get_sample_lost_status, entity).total_count, 0, 0, 0};
  }
  return {};
}

void Events::close() {
  const std::lock_guard lock(mutex_);
  watchers_.fill({});
}

}  // namespace tfloom::dds
