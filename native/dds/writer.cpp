#include "dds/writer.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/busy_wait.hpp"
#include "dds/packets.hpp"
#include "dds/serdata.hpp"
#include "dds/topic_type.hpp"

namespace tfloom::dds {
namespace {

constexpr std::size_t alignment = 4;

constexpr std::size_t min_kept_size = 256;  // below any size of fragments
constexpr std::size_t max_kept_size = 64 << 20;
constexpr std::int64_t kept_wait_ns = 100'000'000;
constexpr int max_kept_waits = 100;

std::size_t padding_of(std::size_t size) { return (alignment - size % alignment) % alignment; }

void check_encapsulation(std::span<const std::byte> data) {
  if (data.size() <= encapsulation_size) {
    throw std::invalid_argument("a sample has four bytes of encapsulation header and at least one of data, not " +
                                std::to_string(data.size()) + " in all");
  }
  if (data[0] != std::byte{0} || data[1] != std::byte{1}) {
    throw std::invalid_argument("a sample starts with 00 01, the header of little-endian CDR");
  }
}

}  // namespace

Writer::Writer(Participant& participant, const TopicName& topic, const Qos& qos, const std::string& user_data,
               bool waits)
    : participant_(participant),
      library_(participant.library()),
      topic_(create_topic(library_, participant.entity(), topic)),
      entity_(library_,
              library_.create_writer(participant.publisher(), topic_.get(),
                                     make_writer_qos(library_, qos, user_data, waits).get(), nullptr),
              "cannot write " + topic.name),
      type_(type_of(library_, topic_.get(), entity_.get())),
      waits_(waits),
      gid_(gid_of(library_, entity_.get())),
      events_(library_, true),
      peers_(library_, true) {
  const ListenerHandle listener = make_listener(library_);
  events_.listen(listener.get());
  entity_.listen(listener);
}

Writer::~Writer() { close(); }

bool Writer::write(std::span<const std::byte> data) {
  check_encapsulation(data);
  std::shared_lock lock(in_use_);
  if (closed_) throw Error("the writer is closed");
  bool is_kept = false;
  if (service_end_ && data.size() > min_kept_size) {
    const std::optional<bool> kept = keep(data, padding_of(data.size()));
    if (!kept) return false;
    is_kept = *kept;
  }
  const bool is_sent = send(Sample(library_, std::move(lock), make_serdata({&data, 1})));
  if (!is_sent && is_kept) service_end_->release_last();
  return is_sent;
}

Writer::Sample Writer::make(Parts parts) {
  check_encapsulation(parts.front());
  // Only `close` excludes writes, so nothing is waited for here where it is possible.
  std::shared_lock lock(in_use_, std::try_to_lock);
  if (!lock.owns_lock() && !closed_) lock.lock();
  if (closed_) throw Error("the writer is closed");
  return {library_, std::move(lock), make_serdata(parts)};
}

bool Writer::send(Sample&& sample) {
  Sample sent(std::move(sample));
  const Result result = library_.writecdr(entity_.get(), std::exchange(sent.serdata_, nullptr));
  if (result == timeout && !waits_) return false;
  library_.check(result, "cannot write");
  note_message_sent();
  return true;
}

Serdata_* Writer::make_serdata(Parts parts) const {
  // Padded here, because the library would otherwise fill the last word from its heap.
  static constexpr std::byte zeros[alignment]{};
  std::array<IoVec, 8> few;  // of most messages
  std::vector<IoVec> many(parts.size() < few.size() ? 0 : parts.size() + 1);
  IoVec* const vectors = many.empty() ? few.data() : many.data();
  IoCount count = 0;
  std::size_t size = 0;
  const auto add = [&](std::span<const std::byte> part) {
    IoVec& vector = vectors[count++];
    vector.iov_base = const_cast<std::byte*>(part.data());
    vector.iov_len = static_cast<decltype(vector.iov_len)>(part.size());
    size += part.size();
  };
  for (const auto& part : parts) add(part);
  if (const std::size_t padding = padding_of(size)) add({zeros, padding});
  Serdata_* sample = library_.serdata_from_ser_iov(type_, data_kind, count, vectors, size);
  if (sample == nullptr) throw std::invalid_argument("the DDS library refused the sample");
  return sample;
}

std::optional<bool> Writer::keep(std::span<const std::byte> data, std::size_t padding) {
  // Samples that have been acknowledged are not sent again, so their copies are released. A full store waits until all
  // are acknowledged, in short steps, so that `close` ends the wait; a reader that acknowledges nothing can delay a
  // server's write by ten seconds only, and then misses the fragments that it asks for later. A client's write doesn't
  // wait: the client holds the request until there is room.
  const auto is_inline = [](const Peer& peer) { return rtps::uses_inline_form(peer.gid); };
  if (std::ranges::none_of(peers_.matched(entity_.get()), is_inline)) return false;
  for (int waits = 0; service_end_->kept_size() > 0; ++waits) {
    const bool is_full = service_end_->kept_size() > max_kept_size;
    if (library_.wait_for_acks(entity_.get(), is_full && waits_ ? kept_wait_ns : 0) != timeout || waits == max_kept_waits) {
      service_end_->release();
    }
    if (!is_full || closed_) break;
    if (!waits_ && service_end_->kept_size() > 0) return std::nullopt;
  }
  std::vector<std::byte> sample(data.size() + padding);
  std::ranges::copy(data, sample.begin());
  service_end_->keep(std::move(sample));
  return true;
}

void Writer::probe() {
  const std::shared_lock lock(in_use_);
  if (closed_) throw Error("the writer is closed");
  // The heartbeat beside it would request none if the writer has written shortly before, but the next one, after the period
  // of heartbeats: benchmarks/node, "first call".
  const AcknowledgementRequest request;
  constexpr std::byte sample{};  // the one octet that the topic's descriptor declares
  const Result result = library_.unregister_instance(entity_.get(), &sample);
  // A writer with so many samples on their way that it would wait probes its readers by these.
  if (result != timeout || waits_) library_.check(result, "cannot probe the readers");
}

std::size_t Writer::matched_count() const { return closed_ ? 0 : peers_.matched_count(entity_.get()); }

std::vector<Peer> Writer::matched() { return closed_ ? std::vector<Peer>() : peers_.matched(entity_.get()); }

void Writer::notify_event(Event event, ReadyQueue::Shared queue, ReadyQueue::Token token) {
  if (!closed_) events_.notify(event, std::move(queue), token);
}

std::optional<Events::Status> Writer::take_event(Event event) {
  return closed_ ? std::nullopt : events_.take(event, entity_.get());
}

void Writer::assert_liveliness() {
  const std::shared_lock lock(in_use_);
  if (closed_) throw Error("the writer is closed");
  library_.check(library_.assert_liveliness(entity_.get()), "cannot assert liveliness");
}

bool Writer::wait_for_acks(std::int64_t timeout_ns) {
  if (closed_) throw Error("the writer is closed");
  const Result result = library_.wait_for_acks(entity_.get(), timeout_ns);
  if (result == timeout) return false;
  library_.check(result, "cannot wait for readers");
  return true;
}

void Writer::close() {
  // The flag lets waiting writes end, and the deletion of the entity those that wait in the library. The topic goes
  // last, when no write runs, because writes use its type.
  if (closed_.exchange(true) || participant_.is_forked()) return;
  entity_.stop_listening();
  events_.close();
  entity_.close();
  const std::unique_lock lock(in_use_);
  topic_.close();
}

}  // namespace tfloom::dds
