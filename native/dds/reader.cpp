#include "dds/reader.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#ifdef __linux__
#include <pthread.h>
#endif

#include "core/time_slice.hpp"
#include "core/wall_clock.hpp"
#include "dds/serdata.hpp"

namespace tfloom::dds {
namespace {

constexpr Result samples_per_batch = 64;  // after a batch, the thread serves other readers

// Return whether the calling thread is one of the library's, by the names that it gives them. A thread of the program
// delivers what it writes to the readers of its own process.
bool is_of_library() {
#ifdef __linux__
  std::array<char, 16> name{};  // the longest that Linux keeps
  if (pthread_getname_np(pthread_self(), name.data(), name.size()) != 0) return false;
  const std::string_view text(name.data());
  return text.starts_with("recv") || text.starts_with("dq.");
#else
  return false;
#endif
}

// Have a thread of the library that delivers samples do so as soon as they arrive.
void deliver_promptly() {
  static thread_local bool is_known = false;
  if (std::exchange(is_known, true)) return;
  if (is_of_library()) use_short_slice();
}

}  // namespace

Reader::Reader(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data)
    : participant_(participant),
      library_(participant.library()),
      topic_(create_topic(library_, participant.entity(), topic)),
      entity_(library_,
              library_.create_reader(participant.subscriber(), topic_.get(),
                                     make_reader_qos(library_, qos, user_data).get(), nullptr),
              "cannot read " + topic.name),
      gid_(gid_of(library_, entity_.get())),
      topic_name_(topic.name),
      user_data_(user_data),
      events_(library_, false, [this] { matches_changed(); }),
      peers_(library_, false),
      drain_task_([this] { return drain(); }) {
  const ListenerHandle listener = make_listener(library_);
  library_.lset_data_available_arg(listener.get(), &Reader::on_data_available, this, true);
  events_.listen(listener.get());
  entity_.listen(listener);
  // The listener was not called for what came before.
  matches_changed();
  if (has_data()) may_have_data_ = true;
}

Reader::~Reader() { close(); }

bool Reader::has_data() const {
  Serdata_* sample = nullptr;
  SampleState state{};
  if (library_.readcdr(entity_.get(), &sample, 1, &state, 0) <= 0) return false;
  library_.serdata_unref(sample);
  return true;
}

void Reader::on_data_available(Entity, void* self) { static_cast<Reader*>(self)->data_available(); }

void Reader::data_available() {
  if (sink_ != nullptr) {
    feed_from_listener();
    return;
  }
  deliver_promptly();
  may_have_data_ = true;
  const std::lock_guard lock(listener_mutex_);
  if (queue_ != nullptr) queue_->post(token_);
}

// The feeder looks up a new writer's gid at once, because samples are often taken after their writer has left.
void Reader::matches_changed() {
  has_new_match_ = true;
  participant_.feeder().schedule(drain_task_);
}

void Reader::notify(ReadyQueue::Shared queue, ReadyQueue::Token token) {
  const std::lock_guard lock(listener_mutex_);
  if (closed_ || sink_ != nullptr) return;
  queue_ = std::move(queue);
  token_ = token;
  if (queue_ != nullptr && may_have_data_) queue_->post(token);
}

void Reader::feed(std::shared_ptr<Sink> sink) {
  std::shared_ptr<Sink> former;  // released last, without a lock, because that may need the GIL
  const std::lock_guard lifecycle(lifecycle_mutex_);
  {
    const std::lock_guard lock(listener_mutex_);
    if (closed_) return;
    queue_ = nullptr;
  }
  participant_.feeder().cancel(drain_task_);
  {
    const std::lock_guard lock(feed_mutex_);  // afterwards, no thread pushes into the former sink
    sink_ = sink.get();
  }
  former = std::exchange(shared_sink_, std::move(sink));
  participant_.feeder().schedule(drain_task_);
}

bool Reader::take(const Receive& receive) {
  while (sink_ == nullptr) {
    Serdata_* serdata = nullptr;
    SampleState state{};
    may_have_data_ = false;  // before the take, because a sample that arrives during it sets it again
    if (library_.takecdr(entity_.get(), &serdata, 1, &state, 0) <= 0) return false;
    may_have_data_ = true;
    const TakenSample sample(library_, serdata);
    if (!state.valid_data) continue;  // the end of an instance, without data
    // A sample in inline form has no header; `receive_inline` puts one before it. Another client's response is skipped.
    const SampleInfo info{state.source_stamp_ns, wall_clock_ns(), peers_.gid(entity_.get(), state.publication)};
    if (service_end_ && rtps::uses_inline_form(info.publisher_gid)) {
      if (!receive_inline(sample.data(), info, receive)) continue;
    } else {
      receive(sample.data(), info);
    }
    return true;
  }
  return false;
}

bool Reader::receive_inline(std::span<const std::byte> data, const SampleInfo& info, const Receive& receive) {
  if (data.size() < rtps::encapsulation_size) return false;
  const auto header = service_end_->take_header(info.publisher_gid, info.source_stamp_ns);
  if (!header) return false;
  std::vector<std::byte> sample;
  sample.reserve(data.size() + rtps::ServiceHeader::size);
  sample.assign(data.begin(), data.begin() + rtps::encapsulation_size);
  rtps::append(sample, *header);
  sample.insert(sample.end(), data.begin() + rtps::encapsulation_size, data.end());
  receive(sample, info);
  return true;
}

// Push on the library's thread, while the data is in the processor's cache. Waking another thread would take longer
// than most sinks do.
void Reader::feed_from_listener() {
  // If the lock is taken, another thread is pushing, and samples must stay in order; the library's thread must not
  // wait. The feeder takes what is left.
  const std::unique_lock lock(feed_mutex_, std::try_to_lock);
  if (!lock || push_batch()) participant_.feeder().schedule(drain_task_);
}

bool Reader::drain() {
  const std::lock_guard lock(feed_mutex_);
  const DeferredQueue::Scope scope(participant_.feeder());
  if (has_new_match_.exchange(false)) update_publishers();
  return push_batch();
}

void Reader::update_publishers() {
  std::vector<Gid> matched;
  for (const Peer& peer : peers_.matched(entity_.get())) matched.push_back(peer.gid);
  const std::vector<Gid> former = std::exchange(publishers_, std::move(matched));
  Sink* sink = sink_;
  if (sink == nullptr) return;
  for (const Gid& gid : former) {
    if (std::ranges::find(publishers_, gid) == publishers_.end()) sink->forget(gid);
  }
}

bool Reader::push_batch() {
  const DeferredQueue::Scope scope(participant_.feeder());
  Sink* sink = sink_;
  if (sink == nullptr) return false;
  Serdata_* serdata[samples_per_batch]{};
  SampleState states[samples_per_batch];
  const Result count = library_.takecdr(entity_.get(), serdata, samples_per_batch, states, 0);
  const std::int64_t received_ns = wall_clock_ns();
  for (Result i = 0; i < count; ++i) {
    const TakenSample sample(library_, serdata[i]);
    const SampleState& state = states[i];
    if (!state.valid_data) continue;
    sink->push(sample.data(), {state.source_stamp_ns, received_ns, peers_.gid(entity_.get(), state.publication)});
  }
  return count == samples_per_batch;
}

std::size_t Reader::matched_count() const { return closed_ ? 0 : peers_.matched_count(entity_.get()); }

std::vector<Peer> Reader::matched() { return closed_ ? std::vector<Peer>() : peers_.matched(entity_.get()); }

void Reader::notify_event(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token) {
  if (!closed_) events_.notify(event, std::move(queue), token);
}

std::optional<Events::Status> Reader::take_event(Event event) {
  return closed_ ? std::nullopt : events_.take(event, entity_.get());
}

void Reader::announce_filter(const std::string& expression, const std::vector<std::string>& parameters) {
  const std::lock_guard lifecycle(lifecycle_mutex_);
  if (closed_ || participant_.is_forked()) return;
  rtps::ServiceForms::of_process().set_content_filter(gid_, {topic_name_, expression, parameters});
  // libddsc has no such parameter: it is added to what it sends. The user data are what it may change of a reader, and it
  // announces the reader anew when they do. Readers of user data pass over keys that they don't know.
  const std::string changed = user_data_ + "filter=" + std::to_string(++announcements_) + ";";
  library_.set_qos(entity_.get(), make_user_data(library_, changed).get());
}

void Reader::close() {
  std::shared_ptr<Sink> former;  // as in `feed`
  const std::lock_guard lifecycle(lifecycle_mutex_);
  if (closed_.exchange(true) || participant_.is_forked()) return;
  entity_.stop_listening();
  participant_.feeder().cancel(drain_task_);
  {
    const std::lock_guard lock(listener_mutex_);
    queue_ = nullptr;
  }
  former = std::move(shared_sink_);
  events_.close();
  if (announcements_ > 0) rtps::ServiceForms::of_process().clear_content_filter(gid_);
  entity_.close();
  topic_.close();
}

}  // namespace tfloom::dds
