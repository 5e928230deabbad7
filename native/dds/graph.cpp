#include "dds/graph.hpp"

#include <cstring>

#include "dds/serdata.hpp"

namespace tfloom::dds {
namespace {

constexpr std::uint32_t samples_per_take = 64;
constexpr std::size_t header_size = 4;
constexpr std::size_t most_early_node_lists = 256;  // bounded, because they come from the wire

Gid to_gid(const void* octets) {
  Gid gid;
  std::memcpy(gid.data(), octets, gid.size());
  return gid;
}

std::string to_string(const char* text) { return text == nullptr ? std::string() : std::string(text); }

// Take all samples of a reader of a built-in topic, and call `receive(sample, is_alive)` for each.
template <typename Sample, typename Receive>
void take_all(const Library& library, Entity reader, const Receive& receive) {
  for (;;) {
    void* samples[samples_per_take]{};
    SampleState states[samples_per_take];
    const Result count = library.take(reader, samples, states, samples_per_take, samples_per_take);
    if (count <= 0) return;
    for (Result i = 0; i < count; ++i) {
      const bool is_alive = states[i].valid_data && states[i].instance_state == alive_instance;
      receive(*static_cast<const Sample*>(samples[i]), is_alive);
    }
    library.return_loan(reader, samples, count);
  }
}

}  // namespace

Graph::Graph(Participant& participant, const TopicName& node_lists, const Qos& qos, const std::string& user_data)
    : participant_(participant), library_(participant.library()) {
  const QosHandle handle = make_reader_qos(library_, qos, user_data);
  node_list_topic_ = create_topic(participant, node_lists);
  participant_reader_ = listen(discovered_participants, nullptr);
  writer_reader_ = listen(discovered_publications, nullptr);
  reader_reader_ = listen(discovered_subscriptions, nullptr);
  node_list_reader_ = listen(node_list_topic_, handle.get());
}

Graph::~Graph() { close(); }

Entity Graph::listen(Entity topic, const Qos_* qos) {
  Listener_* listener = library_.create_listener(nullptr);
  library_.lset_data_available_arg(listener, &Graph::on_data_available, this, true);
  // Created on the participant, because the library reads its built-in topics through a subscriber of its own.
  const Entity reader = library_.create_reader(participant_.entity(), topic, qos, listener);
  library_.delete_listener(listener);
  return library_.check(reader, "cannot listen to the graph");
}

void Graph::on_data_available(Entity, void* self) {
  auto* graph = static_cast<Graph*>(self);
  graph->participant_.feeder().schedule(*graph);
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

void Graph::notify(ReadyQueue* queue, ReadyQueue::Token token) {
  const std::lock_guard lock(mutex_);
  queue_ = queue;
  token_ = token;
}

void Graph::update() {
  if (closed_) return;
  const std::uint64_t before = changes_;
  update_participants();
  update_endpoints(writer_reader_, true);
  update_endpoints(reader_reader_, false);
  update_node_lists();
  if (changes_ != before && queue_ != nullptr) queue_->post(token_);
}

void Graph::update_participants() {
  take_all<DiscoveredParticipant>(library_, participant_reader_, [this](const auto& sample, bool is_alive) {
    ++changes_;
    const Gid gid = to_gid(sample.key.octets);
    if (!is_alive) {
      participants_.erase(gid);
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
    const Gid gid = to_gid(sample.key.octets);
    if (!is_alive) {
      endpoints_.erase(gid);
      return;
    }
    endpoints_[gid] = {gid,
                       to_gid(sample.participant_key.octets),
                       is_writer,
                       to_string(sample.topic_name),
                       to_string(sample.type_name),
                       read_user_data(library_, sample.qos),
                       read_qos(library_, sample.qos)};
  });
}

void Graph::update_node_lists() {
  Serdata_* serdata = nullptr;
  SampleState state{};
  while (library_.takecdr(node_list_reader_, &serdata, 1, &state, 0) > 0) {
    const TakenSample sample(library_, serdata);
    if (state.valid_data) put_node_list(sample.data());
    serdata = nullptr;
  }
}

// After its encapsulation header, a node list starts with the GUID of its participant.
void Graph::put_node_list(std::span<const std::byte> data) {
  if (data.size() < header_size + sizeof(Gid)) return;
  ++changes_;
  const Gid gid = to_gid(data.data() + header_size);
  const auto found = participants_.find(gid);
  if (found != participants_.end()) {
    found->second.node_list.assign(data.begin(), data.end());
    return;
  }
  if (early_node_lists_.size() >= most_early_node_lists) early_node_lists_.clear();
  early_node_lists_[gid].assign(data.begin(), data.end());
}

void Graph::close() {
  if (participant_.is_forked()) return;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return;
    closed_ = true;
    queue_ = nullptr;
  }
  const Entity readers[] = {participant_reader_, writer_reader_, reader_reader_, node_list_reader_};
  for (const Entity reader : readers) library_.set_listener(reader, nullptr);
  participant_.feeder().cancel(*this);
  for (const Entity reader : readers) library_.delete_entity(reader);
  library_.delete_entity(node_list_topic_);
}

}  // namespace tfloom::dds
