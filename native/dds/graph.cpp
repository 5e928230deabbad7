#include "dds/graph.hpp"

#include <cstring>

#include "dds/serdata.hpp"
#include "rtps/announcements.hpp"
#include "rtps/message.hpp"
#include "rtps/service_forms.hpp"

namespace tfloom::dds {
namespace {

constexpr std::uint32_t samples_per_take = 64;
constexpr std::size_t max_early_node_lists = 256;  // bounded, because they come from the wire

Gid to_gid(const void* bytes) {
  Gid gid;
  std::memcpy(gid.data(), bytes, gid.size());
  return gid;
}

std::string to_string(const char* text) { return text == nullptr ? std::string() : std::string(text); }

// Samples that the library lends, until they are returned by the destructor.
struct Loan {
  const Library& library;
  Entity reader;
  void** samples;
  Result count;

  ~Loan() { library.return_loan(reader, samples, count); }
};

// Take all samples of a reader of a built-in topic, and call `receive(sample, is_alive)` for each.
template <typename Sample, typename Receive>
void take_all(const Library& library, Entity reader, const Receive& receive) {
  for (;;) {
    void* samples[samples_per_take]{};
    SampleState states[samples_per_take];
    const Result count = library.take(reader, samples, states, samples_per_take, samples_per_take);
    if (count <= 0) return;
    const Loan loan{library, reader, samples, count};
    for (Result i = 0; i < count; ++i) {
      const bool is_alive = states[i].valid_data && states[i].instance_state == alive_instance;
      receive(*static_cast<const Sample*>(samples[i]), is_alive);
    }
  }
}

}  // namespace

Graph::Graph(Participant& participant, const TopicName& node_lists, const Qos& qos, const std::string& user_data)
    : participant_(participant),
      library_(participant.library()),
      drain_task_([this] { return drain(); }),
      node_list_topic_(create_topic(library_, participant.entity(), node_lists)),
      participant_reader_(create_reader(discovered_participants, nullptr)),
      writer_reader_(create_reader(discovered_publications, nullptr)),
      reader_reader_(create_reader(discovered_subscriptions, nullptr)),
      node_list_reader_(create_reader(node_list_topic_.get(), make_reader_qos(library_, qos, user_data).get())) {
  try {
    listen();
  } catch (...) {
    close();  // some of the readers listen already, and may have scheduled a drain
    throw;
  }
}

Graph::~Graph() { close(); }

OwnedEntity Graph::create_reader(Entity topic, const Qos_* qos) const {
  // Created on the participant, because the library reads its built-in topics through an internal subscriber.
  return {library_, library_.create_reader(participant_.entity(), topic, qos, nullptr), "cannot listen to the graph"};
}

void Graph::listen() {
  const ListenerHandle listener = make_listener(library_);
  library_.lset_data_available_arg(listener.get(), &Graph::on_data_available, this, true);
  for (OwnedEntity* reader : {&participant_reader_, &writer_reader_, &reader_reader_, &node_list_reader_}) {
    reader->listen(listener);
  }
  participant_.feeder().schedule(drain_task_);  // for what was received before
}

void Graph::on_data_available(Entity, void* self) {
  auto* graph = static_cast<Graph*>(self);
  graph->participant_.feeder().schedule(graph->drain_task_);
}

bool Graph::drain() {
  const std::lock_guard lock(mutex_);
  update();
  return false;
}

Graph::Snapshot Graph::snapshot() {
  const std::lock_guard lock(mutex_);
  update();
  Snapshot snapshot;
  snapshot.participants.assign(participants_.begin(), participants_.end());
  for (const auto& [gid, endpoint] : endpoints_) snapshot.endpoints.push_back(endpoint);
  return snapshot;
}

std::uint64_t Graph::changes() {
  const std::lock_guard lock(mutex_);
  update();
  return changes_;
}

void Graph::notify(ReadyQueue::Shared queue, ReadyQueue::Token token) {
  const std::lock_guard lock(mutex_);
  queue_ = std::move(queue);
  token_ = token;
}

void Graph::update() {
  // Called by the feeder and by each query, so that a query sees all that has arrived, though the feeder may be busy.
  // One token is posted for all changes of an update.
  if (closed_) return;
  const std::uint64_t before = changes_;
  update_participants();
  update_endpoints(reader_reader_.get(), false);
  update_endpoints(writer_reader_.get(), true);
  update_node_lists();
  prompt_heartbeats();
  if (changes_ != before && queue_ != nullptr) queue_->post(token_);
}

void Graph::update_participants() {
  take_all<DiscoveredParticipant>(library_, participant_reader_.get(), [this](const auto& sample, bool is_alive) {
    ++changes_;
    const Gid gid = to_gid(sample.key.bytes);
    if (!is_alive) {
      participants_.erase(gid);
      rtps::ServiceForms::of_process().forget(rtps::prefix_of(gid));  // it ended its presence, or its lease has ended
      return;
    }
    ParticipantInfo& info = participants_[gid];
    info.user_data = read_user_data(library_, sample.qos);
    if (auto early = early_node_lists_.extract(gid)) info.node_list = std::move(early.mapped());
  });
}

void Graph::update_endpoints(Entity reader, bool is_writer) {
  take_all<DiscoveredEndpoint>(library_, reader, [this, is_writer](const auto& sample, bool is_alive) {
    ++changes_;
    const Gid gid = to_gid(sample.key.bytes);
    if (!is_alive) {
      endpoints_.erase(gid);
      return;
    }
    const auto [place, is_new] = endpoints_.try_emplace(gid);
    EndpointInfo& info = place->second;
    info = {gid,
            to_gid(sample.participant_key.bytes),
            is_writer,
            to_string(sample.topic_name),
            to_string(sample.type_name),
            read_user_data(library_, sample.qos),
            read_qos(library_, sample.qos)};
    if (is_new && is_writer && rtps::is_of_fast_dds(rtps::prefix_of(gid)) && !rtps::is_of_service(info.topic_name) &&
        info.qos.reliability == Reliability::reliable) {
      new_writers_.push_back({info.topic_name, info.type_name});
    }
  });
}

// A writer of Fast DDS sends a heartbeat to a reader when it discovers it. If that is before the library has discovered
// the writer, the heartbeat is dropped, and the next follows a message by up to 3 s. Until then the library can't request
// what it lacks: a transient-local reader gets no messages, and a message of several packets is lost, because the first
// heartbeat counts as the beginning of what volatile readers receive. So a reader is created on the topic, for which the
// writer sends another heartbeat, and deleted. Readers that are created after the discovery of the writer need none.
//
// Not for services: the writer sends that reader a gap for the messages before it, which the library takes for all readers,
// so a request that precedes its discovery would be lost. `rtps::ServiceForms::receive` inserts heartbeats for them.
void Graph::prompt_heartbeats() {
  if (new_writers_.empty()) return;
  // Only the topics that this participant reads reliably: other readers here don't wait for the heartbeat.
  for (const auto& [gid, info] : endpoints_) {
    if (info.is_writer || info.participant != participant_.gid() || info.qos.reliability != Reliability::reliable) continue;
    const auto is_topic = [&info](const TopicName& topic) {
      return topic.name == info.topic_name && topic.type_name == info.type_name;
    };
    if (std::erase_if(new_writers_, is_topic) != 0) prompt_heartbeat({info.topic_name, info.type_name});
    if (new_writers_.empty()) return;
  }
  new_writers_.clear();
}

void Graph::prompt_heartbeat(const TopicName& topic) const {
  try {
    const OwnedEntity topic_entity = create_topic(library_, participant_.entity(), topic);
    const QosHandle qos = make_reader_qos(library_, Qos(), std::string());
    const OwnedEntity reader = create_reader(topic_entity.get(), qos.get());
  } catch (const Error&) {
    // The writer's next heartbeat comes later.
  }
}

void Graph::update_node_lists() {
  Serdata_* serdata = nullptr;
  SampleState state{};
  while (library_.takecdr(node_list_reader_.get(), &serdata, 1, &state, 0) > 0) {
    const TakenSample sample(library_, serdata);
    if (state.valid_data) put_node_list(sample.data());
    serdata = nullptr;
  }
}

// After its encapsulation header, a node list starts with the GUID of its participant.
void Graph::put_node_list(std::span<const std::byte> data) {
  if (data.size() < encapsulation_size + sizeof(Gid)) return;
  ++changes_;
  const Gid gid = to_gid(data.data() + encapsulation_size);
  const auto participant = participants_.find(gid);
  if (participant != participants_.end()) {
    participant->second.node_list.assign(data.begin(), data.end());
    return;
  }
  // The list is here before its participant has been discovered. Keep it for `update_participants`.
  if (early_node_lists_.size() >= max_early_node_lists) early_node_lists_.clear();
  early_node_lists_[gid].assign(data.begin(), data.end());
}

void Graph::close() {
  if (participant_.is_forked()) return;
  // The lock is released before `cancel`, which waits for a running drain: the drain needs the lock.
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = true;
    queue_ = nullptr;
  }
  OwnedEntity* const readers[] = {&participant_reader_, &writer_reader_, &reader_reader_, &node_list_reader_};
  for (OwnedEntity* reader : readers) reader->stop_listening();
  participant_.feeder().cancel(drain_task_);
  for (OwnedEntity* reader : readers) reader->close();
  node_list_topic_.close();
}

}  // namespace tfloom::dds
