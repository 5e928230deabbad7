// The owners of DDS entities on a library that fails on request, and that calls each listener from its first moment on,
// from a thread of its own. Returns 0 if a constructor that threw left neither an entity nor a listener behind, and if no
// listener was called after it had been removed; the sanitizer checks the rest.
#include <atomic>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "checks.hpp"
#include "core/sample_queue.hpp"
#include "dds/graph.hpp"
#include "dds/participant.hpp"
#include "dds/reader.hpp"
#include "dds/writer.hpp"

using namespace tfloom::dds;

namespace tfloom::dds {

struct Listener_ {
  void (*on_data)(Entity, void*) = nullptr;
  void (*on_match)(Entity, MatchedStatus, void*) = nullptr;
  void* data_argument = nullptr;
  void* match_argument = nullptr;
};
struct Qos_ {};
struct Sertype_ {};
struct Serdata_ {};

}  // namespace tfloom::dds

namespace {

// The state of the library. Listeners are called with the lock held, so that `set_listener` waits for a running one.
struct Fake {
  std::mutex mutex;
  std::map<Entity, Listener_> entities;  // guarded by mutex, like the next two
  Entity last = 0;
  int listeners_and_qos = 0;
  std::atomic<int> calls_until_failure{-1};  // -1: none fails
  std::atomic<bool> is_ending{false};
  std::atomic<int> listener_calls{0};
} fake;

constexpr Result failure = -1;

bool fails() { return fake.calls_until_failure >= 0 && fake.calls_until_failure-- == 0; }

void call(Entity entity, const Listener_& listener) {
  ++fake.listener_calls;
  if (listener.on_match != nullptr) listener.on_match(entity, {}, listener.match_argument);
  if (listener.on_data != nullptr) listener.on_data(entity, listener.data_argument);
}

void call_listeners() {
  while (!fake.is_ending) {
    {
      const std::lock_guard lock(fake.mutex);
      for (const auto& [entity, listener] : fake.entities) call(entity, listener);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(20));
  }
}

Entity create(const Listener_* listener) {
  if (fails()) return failure;
  const Entity entity = [&] {
    const std::lock_guard lock(fake.mutex);
    const Entity created = ++fake.last;
    fake.entities[created] = listener == nullptr ? Listener_{} : *listener;
    if (listener != nullptr) call(created, *listener);
    return created;
  }();
  if (listener != nullptr) std::this_thread::sleep_for(std::chrono::microseconds(100));  // for the other thread
  return entity;
}

Library make_library() {
  Library l{};
  l.create_domain = [](std::uint32_t, const char*) { return create(nullptr); };
  l.create_participant = [](std::uint32_t, const Qos_*, const Listener_* listener) { return create(listener); };
  l.create_publisher = l.create_subscriber = [](Entity, const Qos_*, const Listener_* listener) {
    return create(listener);
  };
  l.create_topic = [](Entity, const TopicDescriptor*, const char*, const Qos_*, const Listener_* listener) {
    return create(listener);
  };
  l.create_writer = l.create_reader = [](Entity, Entity, const Qos_*, const Listener_* listener) {
    return create(listener);
  };
  l.delete_entity = [](Entity entity) -> Result {
    const std::lock_guard lock(fake.mutex);
    const auto found = fake.entities.find(entity);
    check(found != fake.entities.end(), "an entity was deleted twice");
    if (found == fake.entities.end()) return failure;
    check(found->second.data_argument == nullptr && found->second.match_argument == nullptr, "an entity was deleted before its listener was removed");
    fake.entities.erase(found);
    return 0;
  };
  l.get_guid = [](Entity entity, Guid* guid) -> Result {
    if (fails()) return failure;
    std::memset(guid->bytes, entity, sizeof guid->bytes);
    return 0;
  };
  l.get_entity_sertype = [](Entity, const Sertype_** type) -> Result {
    static const Sertype_ only;
    *type = &only;
    return fails() ? failure : 0;
  };
  l.set_listener = [](Entity entity, const Listener_* listener) -> Result {
    if (listener != nullptr && fails()) return failure;
    const std::lock_guard lock(fake.mutex);
    fake.entities[entity] = listener == nullptr ? Listener_{} : *listener;
    return 0;
  };
  l.strretcode = [](Result) -> const char* { return "it was to fail"; };
  l.free = [](void*) {};
  l.create_listener = [](void*) {
    const std::lock_guard lock(fake.mutex);
    ++fake.listeners_and_qos;
    return new Listener_;
  };
  l.delete_listener = [](Listener_* listener) {
    const std::lock_guard lock(fake.mutex);
    --fake.listeners_and_qos;
    delete listener;
  };
  l.lset_data_available_arg = [](Listener_* listener, void (*call_back)(Entity, void*), void* argument, bool) -> Result {
    listener->on_data = call_back;
    listener->data_argument = argument;
    return 0;
  };
  l.lset_publication_matched_arg = l.lset_subscription_matched_arg =
      [](Listener_* listener, void (*call_back)(Entity, MatchedStatus, void*), void* argument, bool) -> Result {
    listener->on_match = call_back;
    listener->match_argument = argument;
    return 0;
  };
  l.lset_offered_incompatible_qos_arg = l.lset_requested_incompatible_qos_arg =
      [](Listener_*, void (*)(Entity, IncompatibleStatus, void*), void*, bool) -> Result { return 0; };
  l.lset_offered_deadline_missed_arg = l.lset_requested_deadline_missed_arg =
      [](Listener_*, void (*)(Entity, DeadlineStatus, void*), void*, bool) -> Result { return 0; };
  l.lset_liveliness_lost_arg = l.lset_sample_lost_arg = [](Listener_*, void (*)(Entity, LostStatus, void*), void*,
                                                           bool) -> Result { return 0; };
  l.lset_liveliness_changed_arg = [](Listener_*, void (*)(Entity, LivelinessStatus, void*), void*, bool) -> Result {
    return 0;
  };
  l.create_qos = [] {
    const std::lock_guard lock(fake.mutex);
    ++fake.listeners_and_qos;
    return new Qos_;
  };
  l.delete_qos = [](Qos_* qos) {
    const std::lock_guard lock(fake.mutex);
    --fake.listeners_and_qos;
    delete qos;
  };
  l.qset_userdata = [](Qos_*, const void*, std::size_t) {};
  l.qset_reliability = [](Qos_*, int, std::int64_t) {};
  l.qset_durability = [](Qos_*, int) {};
  l.qset_durability_service = [](Qos_*, std::int64_t, int, std::int32_t, std::int32_t, std::int32_t, std::int32_t) {};
  l.qset_history = [](Qos_*, int, std::int32_t) {};
  l.qset_deadline = l.qset_lifespan = [](Qos_*, std::int64_t) {};
  l.qset_liveliness = [](Qos_*, int, std::int64_t) {};
  l.qset_data_representation = [](Qos_*, std::uint32_t, const std::int16_t*) {};
  l.qset_writer_data_lifecycle = [](Qos_*, bool) {};
  const auto nothing_waits = [](Entity, Serdata_**, std::uint32_t, SampleState*, std::uint32_t) -> Result { return 0; };
  l.readcdr = nothing_waits;
  l.takecdr = nothing_waits;
  l.take = [](Entity, void**, SampleState*, std::size_t, std::uint32_t) -> Result { return 0; };
  l.get_matched_publications = l.get_matched_subscriptions = [](Entity entity, InstanceHandle*, std::size_t) -> Result {
    const std::lock_guard lock(fake.mutex);
    check(fake.entities.contains(entity), "matches were looked up before the entity was known, or after its deletion");
    return 0;
  };
  return l;
}

// What a user of the wire creates, in this order. A throw destroys what was created before.
void live(const Library& library) {
  const TopicName topic{"rt/topic", "Type_"};
  const auto former = std::make_shared<tfloom::SampleQueue>(1), sink = std::make_shared<tfloom::SampleQueue>(1);
  Participant participant(library, 1, "", "", false);
  Graph graph(participant, topic, {}, "");
  Writer writer(participant, topic, {}, "");
  Reader reader(participant, topic, {}, "");
  reader.feed(former);
  reader.feed(sink);
  check(former.use_count() == 1, "a reader shares a sink in whose place it feeds another");
  check(sink.use_count() == 2, "a reader does not share the sink that it feeds");
  reader.close();
  check(sink.use_count() == 1, "a closed reader shares a sink");
}

void check_nothing_is_left(const std::string& when) {
  const std::lock_guard lock(fake.mutex);
  check(fake.entities.empty(), std::to_string(fake.entities.size()) + " entities are left " + when);
  check(fake.listeners_and_qos == 0, "listeners or qualities of service are left " + when);
}

}  // namespace

int main() {
  const Library library = make_library();
  std::thread caller(call_listeners);
  int failures = 0;
  for (;;) {
    fake.calls_until_failure = failures;
    try {
      live(library);
      break;
    } catch (const Error&) {
      check_nothing_is_left("after the failure of call " + std::to_string(failures));
      ++failures;
    }
  }
  fake.calls_until_failure = -1;
  check(failures > 20, "the library failed " + std::to_string(failures) + " times only");
  for (int i = 0; i < 200; ++i) live(library);
  check_nothing_is_left("at the end");
  check(fake.listener_calls > 100, "hardly any listener was called");
  fake.is_ending = true;
  caller.join();
  return faults == 0 ? 0 : 1;
}
