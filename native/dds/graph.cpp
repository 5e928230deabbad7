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
      source_([this] { return drain(); }),
      node_list_topic_(create_topic(participant, node_lists)),
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
  // Created on the participant, because the library reads its built-in topics through a subscriber of its own.
  return {library_, library_.create_reader(participant_.entity(), topic, qos, nullptr), "cannot listen to the graph"};
}

void Graph::listen() {
  const ListenerHandle listener = make_listener(library_);
  library_.lset_data_available_arg(listener.get(), &Graph::on_data_available, this, true);
  for (OwnedEntity* reader : {&participant_reader_, &writer_reader_, &reader_reader_, &node_list_reader_}) {
    reader->listen(listener);
  }
  participant_.feeder().schedule(source_);  // for what was received before
}

void Graph::on_data_available(Entity, void* self) {
  auto* graph = static_cast<Graph*>(self);
  graph->participant_.feeder().schedule(graph->source_);
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
  update_endpoints(writer_reader_.get(), true);
  update_endpoints(reader_reader_.get(), false);
  update_node_lists();
  if (changes_ != before && queue_ != nullptr) queue_->post(token_);
}

void Graph::update_participants() {
  take_all<DiscoveredParticipant>(library_, participant_reader_.get(), [this](const auto& sample, bool is_alive) {
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
  while (library_.takecdr(node_list_reader_.get(), &serdata, 1, &state, 0) > 0) {
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
  OwnedEntity* const readers[] = {&participant_reader_, &writer_reader_, &reader_reader_, &node_list_reader_};
  for (OwnedEntity* reader : readers) reader->stop_listening();
  participant_.feeder().cancel(source_);
  for (OwnedEntity* reader : readers) reader->close();
  node_list_topic_.close();
}

}  // namespace tfloom::dds
