#include "dds/reader.hpp"

#include <chrono>
#include <cstring>

#include "dds/serdata.hpp"

namespace tfloom::dds {
namespace {

constexpr int samples_a_turn = 64;        // then the feeder's next source gets its turn
constexpr std::size_t cached_gids = 1024;  // of writers that may be gone

std::int64_t now_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

Reader::Reader(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data)
    : participant_(participant), library_(participant.library()), topic_(create_topic(participant, topic)) {
  const QosHandle handle = make_reader_qos(library_, qos, user_data);
  Listener_* listener = library_.create_listener(nullptr);
  library_.lset_data_available_arg(listener, &Reader::on_data_available, this, true);
  entity_ = library_.create_reader(participant.subscriber(), topic_, handle.get(), listener);
  library_.delete_listener(listener);
  if (entity_ < 0) library_.delete_entity(topic_);
  library_.check(entity_, "cannot read " + topic.name);
  gid_ = gid_of(library_, entity_);
}

Reader::~Reader() { close(); }

void Reader::on_data_available(Entity, void* self) { static_cast<Reader*>(self)->data_available(); }

void Reader::data_available() {
  if (sink_ != nullptr) {
    participant_.feeder().schedule(*this);
    return;
  }
  const std::lock_guard lock(listener_mutex_);
  if (queue_ != nullptr) queue_->post(token_);
}

void Reader::notify(ReadyQueue* queue, ReadyQueue::Token token) {
  const std::lock_guard lock(listener_mutex_);
  if (closed_ || sink_ != nullptr) return;
  queue_ = queue;
  token_ = token;
  if (queue != nullptr) queue->post(token);
}

void Reader::feed(Sink* sink) {
  {
    const std::lock_guard lock(listener_mutex_);
    if (closed_) return;
    queue_ = nullptr;
  }
  participant_.feeder().forget(*this);  // a sink that was fed before is let go
  sink_ = sink;
  participant_.feeder().schedule(*this);
}

bool Reader::take(const Receive& receive) { return sink_ == nullptr && take_one(receive); }

bool Reader::take_one(const Receive& receive) {
  for (;;) {
    Serdata_* serdata = nullptr;
    SampleState state{};
    if (library_.takecdr(entity_, &serdata, 1, &state, 0) <= 0) return false;
    const TakenSample sample(library_, serdata);
    if (!state.valid_data) continue;
    receive(sample.data(), {state.source_stamp_ns, now_ns(), publisher_gid(state.publication)});
    return true;
  }
}

bool Reader::drain() {
  Sink* sink = sink_;
  if (sink == nullptr) return false;
  for (int i = 0; i < samples_a_turn; ++i) {
    if (!take_one([sink](auto data, const SampleInfo& info) { sink->push(data, info); })) return false;
  }
  return true;
}

Gid Reader::publisher_gid(InstanceHandle publication) {
  const std::lock_guard lock(gids_mutex_);
  if (const auto found = gids_.find(publication); found != gids_.end()) return found->second;
  Gid gid{};
  DiscoveredEndpoint* endpoint = library_.get_matched_publication_data(entity_, publication);
  if (endpoint == nullptr) return gid;  // it has left since
  std::memcpy(gid.data(), endpoint->key.octets, gid.size());
  library_.builtintopic_free_endpoint(endpoint);
  if (gids_.size() >= cached_gids) gids_.clear();
  gids_.emplace(publication, gid);
  return gid;
}

std::size_t Reader::matched_count() const {
  if (closed_) return 0;
  const Result count = library_.get_matched_publications(entity_, nullptr, 0);
  return count < 0 ? 0 : static_cast<std::size_t>(count);
}

void Reader::close() {
  if (closed_.exchange(true) || participant_.is_forked()) return;
  library_.set_listener(entity_, nullptr);  // returns when no listener runs
  participant_.feeder().forget(*this);
  {
    const std::lock_guard lock(listener_mutex_);
    queue_ = nullptr;
  }
  library_.delete_entity(entity_);
  library_.delete_entity(topic_);
}

}  // namespace tfloom::dds
