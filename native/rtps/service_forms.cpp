#include "rtps/service_forms.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <ranges>
#include <utility>

#ifndef _WIN32
#include <pthread.h>
#endif

namespace tfloom::rtps {
namespace {

// The parameter that holds the identity of a related sample: a GUID and a sequence number (9.6.4), and the id that it
// had before it was a standard.
constexpr std::uint16_t related_sample_id = 0x0083;
constexpr std::uint16_t former_related_sample_id = 0x800f;
constexpr std::size_t related_sample_size = 24;
constexpr std::uint64_t unknown_sequence_number = 0xffffffff'00000000;

constexpr std::size_t header_end = encapsulation_size + ServiceHeader::size;
constexpr std::size_t max_remembered = 200'000;  // requests and responses that have not been taken yet
constexpr std::size_t max_sent = 1024;  // requests of a client: far more than the ten that a server on Fast DDS keeps
constexpr std::size_t max_of_writer = max_remembered / 2;  // so that no writer displaces all others
constexpr std::int64_t stamp_tolerance_ns = 2;  // a stamp on the wire has the unit 2^-32 s
constexpr std::int64_t no_stamp = -1;
constexpr std::size_t max_datagram_size = 65'507;

std::int64_t stamp_ns(const Submessage& info_ts) {
  const Fields fields = info_ts.fields();
  if ((info_ts.flags & invalidate_flag) != 0 || !fields.has(12)) return no_stamp;
  const std::uint64_t fraction = fields.u32(8);
  return std::int64_t{fields.u32(4)} * 1'000'000'000 +
         static_cast<std::int64_t>((fraction * 1'000'000'000 + (std::uint64_t{1} << 31)) >> 32);
}

bool is_stamp(std::int64_t arrived_ns, std::int64_t taken_ns) {
  return arrived_ns == no_stamp || std::abs(arrived_ns - taken_ns) <= stamp_tolerance_ns;
}

// Return the related sample that a submessage's inline QoS names, or nullopt if it names none.
std::optional<Related> related_sample(const Data& data) {
  Parameters parameters(data.inline_qos, data.is_little_endian);
  while (const auto parameter = parameters.next()) {
    if (parameter->id != related_sample_id && parameter->id != former_related_sample_id) continue;
    if (!parameter->value.has(related_sample_size)) return std::nullopt;
    return Related{bytes_at<16>(parameter->value.bytes(), 0), parameter->value.sequence_number(16)};
  }
  return std::nullopt;
}

// The two high bits of an entity's kind are 0 if a user has created it (9.3.1.2).
bool is_user_endpoint(const EntityId& entity) { return (entity[3] & 0xc0) == 0; }

template <typename Integer>
void store(std::byte* at, Integer value) {  // little-endian
  for (std::size_t i = 0; i < sizeof(Integer); ++i) at[i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
}

void store_sequence_number(std::byte* at, std::uint64_t number) {
  store(at, static_cast<std::uint32_t>(number >> 32));
  store(at + 4, static_cast<std::uint32_t>(number));
}

void append(std::vector<std::byte>& out, Bytes bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

ServiceHeader read_header(Bytes sample) {
  ServiceHeader header;
  header.client = bytes_at<8>(sample, encapsulation_size);
  const Fields fields(sample, true);
  header.number = static_cast<std::int64_t>(std::uint64_t{fields.u32(encapsulation_size + 12)} << 32 |
                                            fields.u32(encapsulation_size + 8));
  return header;
}

// Return the bytes of the fragments with the same numbers in inline form; empty if that form has no such fragments.
std::vector<std::byte> inline_fragment(Bytes sample, const Data& data) {
  const std::size_t inline_size = sample.size() - ServiceHeader::size;
  const std::size_t begin = std::size_t{data.first_fragment - 1} * data.fragment_size;
  const std::size_t end = std::min(begin + std::size_t{data.fragment_count} * data.fragment_size, inline_size);
  std::vector<std::byte> fragment;
  if (begin >= end) return fragment;
  // [begin, end) counts in the inline form: the encapsulation header, then what follows the service's header.
  if (begin < encapsulation_size) append(fragment, sample.subspan(begin, std::min(end, encapsulation_size) - begin));
  const std::size_t first = std::max(begin, encapsulation_size);
  if (first < end) append(fragment, sample.subspan(first + ServiceHeader::size, end - first));
  return fragment;
}

constexpr std::size_t heartbeat_size = 32;

void write_heartbeat(std::byte* at, const EntityId& reader, const EntityId& writer, std::uint64_t first,
                     std::uint64_t last) {
  at[0] = static_cast<std::byte>(Kind::heartbeat);
  // An acknowledgement is requested if it counts samples.
  at[1] = static_cast<std::byte>(first > last ? little_endian_flag | final_flag : little_endian_flag);
  store(at + 2, static_cast<std::uint16_t>(heartbeat_size - submessage_header_size));
  std::memcpy(at + 4, reader.data(), reader.size());
  std::memcpy(at + 8, writer.data(), writer.size());
  store_sequence_number(at + 12, first);
  store_sequence_number(at + 20, last);
  store(at + 28, static_cast<std::uint32_t>(last + 1));  // counts the heartbeats, and grows with the samples
}

// Append a gap of one sequence number (8.3.7.4), so that a participant's readers don't wait for a sample of others.
void append_gap(std::vector<std::byte>& out, const Data& data, const EntityId& reader) {
  constexpr std::size_t gap_size = 32;  // with an empty bitmap
  const std::size_t start = out.size();
  out.resize(start + gap_size);
  std::byte* at = &out[start];
  at[0] = static_cast<std::byte>(Kind::gap);
  at[1] = static_cast<std::byte>(little_endian_flag);
  store(at + 2, static_cast<std::uint16_t>(gap_size - submessage_header_size));
  std::memcpy(at + 4, reader.data(), reader.size());
  std::memcpy(at + 8, data.writer.data(), data.writer.size());
  store_sequence_number(at + 12, data.sequence_number);
  store_sequence_number(at + 20, data.sequence_number + 1);
}

// Return the inline QoS that names a related sample, with its sentinel.
std::array<std::byte, 32> related_identity(const Related& related) {
  std::array<std::byte, 32> list{};
  store(list.data(), related_sample_id);
  store(list.data() + 2, static_cast<std::uint16_t>(related_sample_size));
  std::memcpy(list.data() + 4, related.gid.data(), related.gid.size());
  store_sequence_number(list.data() + 20, related.sequence_number);
  store(list.data() + 28, sentinel_id);
  return list;
}

// Erase the smallest keys, which are sequence numbers.
template <typename Map>
void erase_oldest(Map& map, std::size_t max_size) {
  while (map.size() > max_size) map.erase(map.begin());
}

std::atomic<ServiceForms*> forms_of_process = nullptr;

#ifndef _WIN32
void start_anew_in_child() { forms_of_process.exchange(new ServiceForms)->abandon(); }
#endif

}  // namespace

void request_acknowledgements(std::span<std::byte> datagram) {
  auto message = Message::of(datagram);
  while (const auto submessage = message ? message->next() : std::nullopt) {
    if (submessage->kind != Kind::heartbeat) continue;
    datagram[static_cast<std::size_t>(submessage->bytes.data() - datagram.data()) + 1] &= ~std::byte{final_flag};
  }
}

void append(std::vector<std::byte>& out, const ServiceHeader& header) {
  const std::size_t start = out.size();
  out.resize(start + ServiceHeader::size);
  std::memcpy(&out[start], header.client.data(), header.client.size());
  store(&out[start + 8], static_cast<std::uint64_t>(header.number));
}

ServiceEnd::ServiceEnd(ServiceForms& forms, bool is_client, std::string service, const Gid& writer, const Gid& reader,
                       const std::array<std::uint8_t, 8>& client)
    : forms_(forms),
      is_client_(is_client),
      service_(std::move(service)),
      writer_(writer),
      reader_(reader),
      client_(client) {}

ServiceEnd::~ServiceEnd() { forms_.remove(*this); }

std::optional<ServiceHeader> ServiceEnd::take_header(const Gid& writer, std::int64_t source_stamp_ns) {
  return forms_.take_header(*this, writer, source_stamp_ns);
}

void ServiceEnd::keep(std::vector<std::byte> sample) {
  const std::lock_guard lock(forms_.mutex_);
  kept_size_ += sample.size();
  kept_.push_back({std::move(sample), 0});
}

void ServiceEnd::release() {
  const std::lock_guard lock(forms_.mutex_);
  kept_.clear();
  kept_size_ = 0;
}

void ServiceEnd::release_last() {
  const std::lock_guard lock(forms_.mutex_);
  if (kept_.empty()) return;
  kept_size_ -= kept_.back().sample.size();
  kept_.pop_back();
}

std::size_t ServiceEnd::kept_size() const {
  const std::lock_guard lock(forms_.mutex_);
  return kept_size_;
}

ServiceForms::ServiceForms() {
  std::random_device random;
  next_key_ = std::uint64_t{random()} << 32 | random();
}

ServiceForms& ServiceForms::of_process() {
  // Never destroyed, because the library's threads may send until the process ends.
  static const bool is_made = [] {
    forms_of_process = new ServiceForms;
#ifndef _WIN32
    pthread_atfork(nullptr, nullptr, start_anew_in_child);
#endif
    return true;
  }();
  static_cast<void>(is_made);
  return *forms_of_process;
}

std::shared_ptr<ServiceEnd> ServiceForms::add_client(const std::string& service, const Gid& writer, const Gid& reader,
                                                     const std::array<std::uint8_t, 8>& client) {
  std::shared_ptr<ServiceEnd> end(new ServiceEnd(*this, true, service, writer, reader, client));
  const std::lock_guard lock(mutex_);
  ends_by_writer_[writer] = end.get();
  clients_by_reader_[reader] = end.get();
  has_ends_ = true;
  return end;
}

std::shared_ptr<ServiceEnd> ServiceForms::add_server(const std::string& service, const Gid& writer,
                                                     const Gid& reader) {
  std::shared_ptr<ServiceEnd> end(new ServiceEnd(*this, false, service, writer, reader, {}));
  const std::lock_guard lock(mutex_);
  ends_by_writer_[writer] = end.get();
  has_ends_ = true;
  return end;
}

void ServiceForms::remove(ServiceEnd& end) {
  if (is_abandoned_) return;
  const std::lock_guard lock(mutex_);
  ends_by_writer_.erase(end.writer_);
  clients_by_reader_.erase(end.reader_);
  has_ends_ = !ends_by_writer_.empty();
  requests_.erase_if([&](const Gid& writer, Requests& requests) {
    if (requests.service != end.service_) return false;
    forget_taken(writer, requests);
    return requests.arrivals.empty();
  });
}

std::size_t ServiceForms::receive(std::span<std::byte> buffer, std::size_t size) {
  const Bytes datagram = Bytes(buffer).first(size);
  auto message = Message::of(datagram);
  if (!message) return size;
  const GuidPrefix source = message->source();
  const bool is_inline = uses_inline_form(source);
  // Where all participants use our form, datagrams pass without the lock, unless a command reads versions. Once a
  // peer of the inline form is known, read what the others announce too: an address may pass from one participant to
  // another.
  if (!is_inline && !has_inline_peers_ && !reads_versions_) return size;
  std::int64_t source_stamp_ns = no_stamp;
  std::vector<Heartbeat> inserted;
  const std::lock_guard lock(mutex_);
  while (const auto submessage = message->next()) {
    if (submessage->kind == Kind::info_src) break;  // a relayed message, which no ROS 2 sends
    if (submessage->kind == Kind::info_ts) source_stamp_ns = stamp_ns(*submessage);  // holds for what follows
    // What a participant announces to the built-in readers: its addresses, its version, and its writers of services.
    const auto data = Data::of(*submessage);
    if (data && !is_user_endpoint(data->writer)) {
      addresses_.read(source, *data);
      discovery_addresses_.read(source, *data);
      if (reads_versions_) versions_.read(source, *data);
      has_inline_peers_ = has_inline_peers_ || is_inline;
      if (const auto writer = is_inline ? announced_service_writer(*data) : std::nullopt) {
        beginnings_.use(*writer);
      }
    }
    if (!is_inline || !has_ends_) continue;
    // What its own endpoints send. A related sample in the inline QoS means that the writer is one of a service.
    const auto at = static_cast<std::size_t>(submessage->bytes.data() - datagram.data());
    if (data && is_user_endpoint(data->writer)) {
      const Gid writer = gid_of(source, data->writer);
      if (const auto related = related_sample(*data)) {
        if (data->is_sample) note_arrival(writer, data->sequence_number, source_stamp_ns, *related);
        beginnings_.use(writer);  // its announcement may arrive later
      }
      insert_heartbeats(writer, *submessage, at, inserted);
    } else if (submessage->kind == Kind::heartbeat && submessage->fields().has(28)) {
      insert_heartbeats(gid_of(source, bytes_at<4>(submessage->bytes, 8)), *submessage, at, inserted);
    }
  }
  // Without room for the heartbeats, the datagram passes as it has arrived.
  if (size + inserted.size() * heartbeat_size > buffer.size()) return size;
  // Insert the last one first: so the offsets before it remain valid, and two at the same offset stay in their order.
  for (const Heartbeat& heartbeat : inserted | std::views::reverse) {
    std::byte* place = buffer.data() + heartbeat.at;
    std::memmove(place + heartbeat_size, place, size - heartbeat.at);
    write_heartbeat(place, heartbeat.reader, heartbeat.writer, heartbeat.first, heartbeat.last);
    size += heartbeat_size;
  }
  return size;
}

// Before a submessage of a writer: a heartbeat that counts no sample, so that all from the first that has arrived are
// received; then, before a sample, one that counts those before it.
void ServiceForms::insert_heartbeats(const Gid& writer, const Submessage& submessage, std::size_t at,
                                     std::vector<Heartbeat>& inserted) {
  // Once a reader has taken a sample of this writer, the library receives from it and needs no help.
  Beginning* const beginning = beginnings_.find(writer);
  if (beginning == nullptr || beginning->is_taken) return;
  const bool is_heartbeat = submessage.kind == Kind::heartbeat;
  const EntityId reader = bytes_at<4>(submessage.bytes, is_heartbeat ? 4 : 8);
  const EntityId entity = bytes_at<4>(submessage.bytes, is_heartbeat ? 8 : 12);
  const std::uint64_t number = submessage.fields().sequence_number(is_heartbeat ? 12 : 16);
  std::uint64_t first = number;
  if (is_heartbeat) {
    if (beginning->first != 0) first = std::max(beginning->first, number);  // what precedes it is no longer there
  } else {
    // The smallest number, because a sample that is sent again follows those after it.
    if (beginning->first != 0) first = std::min(beginning->first, number);
    beginning->first = first;
  }
  if (first == 0) return;  // no sample has this number, and the one before it would be the greatest
  inserted.push_back({at, reader, entity, first, first - 1});
  if (!is_heartbeat && first < number) inserted.push_back({at, reader, entity, first, number - 1});
}

void ServiceForms::note_arrival(const Gid& writer, std::uint64_t sequence_number, std::int64_t source_stamp_ns,
                                const Related& related) {
  const auto by_reader = clients_by_reader_.find(related.gid);
  const auto by_writer = ends_by_writer_.find(related.gid);
  ServiceEnd* client = by_reader != clients_by_reader_.end() ? by_reader->second
                       : by_writer != ends_by_writer_.end()  ? by_writer->second
                                                             : nullptr;
  if (client == nullptr) {
    note_request(writer, related.gid, sequence_number, source_stamp_ns);
    return;
  }
  const auto sent = client->request_numbers_.find(related.sequence_number);
  if (sent == client->request_numbers_.end()) return;
  auto& arrivals = client->responses_.use(writer);
  arrivals[sequence_number] = {source_stamp_ns, {client->client_, sent->second}};
  erase_oldest(arrivals, max_remembered);
}

void ServiceForms::note_request(const Gid& writer, const Gid& client, std::uint64_t sequence_number,
                                std::int64_t source_stamp_ns) {
  // Before the new one, so that the one that is displaced can be counted.
  if (requests_.is_full() && requests_.find(writer) == nullptr) forget_oldest_requests();
  Requests& requests = requests_.use(writer);
  const ServiceHeader header{key_of(client), static_cast<std::int64_t>(sequence_number)};
  if (requests.arrivals.insert_or_assign(sequence_number, ServiceEnd::Arrival{source_stamp_ns, header}).second) {
    ++arrivals_;
  }
  const std::size_t size = requests.arrivals.size();
  erase_oldest(requests.arrivals, max_of_writer);
  arrivals_ -= size - requests.arrivals.size();
  while (arrivals_ > max_remembered) forget_oldest_requests();
}

void ServiceForms::forget_oldest_requests() {
  if (const auto oldest = requests_.take_oldest()) arrivals_ -= oldest->second.arrivals.size();
}

std::array<std::uint8_t, 8> ServiceForms::key_of(const Gid& client) {
  if (keys_.find(client) != nullptr) return keys_.use(client);
  if (keys_.is_full()) inline_clients_.erase(keys_.take_oldest()->second);
  std::array<std::uint8_t, 8> key{};
  std::memcpy(key.data(), &next_key_, key.size());
  ++next_key_;
  keys_.use(client) = key;
  inline_clients_[key] = client;
  return key;
}

// The stamp selects the sample among those that arrived, because the reader has no sequence numbers. Samples of
// a writer are taken in their order, so all before it are forgotten.
std::optional<ServiceHeader> ServiceForms::take_header(ServiceEnd& end, const Gid& writer,
                                                       std::int64_t source_stamp_ns) {
  const std::lock_guard lock(mutex_);
  if (end.is_client_) {
    // A client has its own list, because a response names the one that it is for.
    auto* const responses = end.responses_.find(writer);
    if (responses == nullptr) return std::nullopt;
    auto& arrivals = *responses;
    const auto arrival = std::ranges::find_if(
        arrivals, [&](const auto& entry) { return is_stamp(entry.second.source_stamp_ns, source_stamp_ns); });
    if (arrival == arrivals.end()) return std::nullopt;
    const ServiceHeader header = arrival->second.header;
    beginnings_.use(writer).is_taken = true;  // so no heartbeats are inserted before its samples any more
    arrivals.erase(arrivals.begin(), std::next(arrival));
    if (arrivals.empty()) end.responses_.erase(writer);
    return header;
  }
  // All servers share the requests of a writer, because a datagram does not name the service: it is known once a server
  // has taken one. If several servers of a service are in this process, each takes each request: each has its place in
  // the list, and `forget_taken` erases only what all of them have passed.
  Requests* const requests = requests_.find(writer);
  if (requests == nullptr) return std::nullopt;
  requests->service = end.service_;
  auto& arrivals = requests->arrivals;
  std::uint64_t& last_taken = end.last_taken_.use(writer);
  const auto arrival = std::find_if(arrivals.upper_bound(last_taken), arrivals.end(), [&](const auto& entry) {
    return is_stamp(entry.second.source_stamp_ns, source_stamp_ns);
  });
  if (arrival == arrivals.end()) return std::nullopt;
  const ServiceHeader header = arrival->second.header;
  beginnings_.use(writer).is_taken = true;
  last_taken = arrival->first;
  forget_taken(writer, *requests);
  if (requests->arrivals.empty()) requests_.erase(writer);
  return header;
}

// A request is forgotten when each server of its service in this process has taken it.
void ServiceForms::forget_taken(const Gid& writer, Requests& requests) {
  auto& arrivals = requests.arrivals;
  // The least of what the servers have taken last. One that has taken nothing of this writer holds back all.
  std::uint64_t taken_by_all = arrivals.empty() ? 0 : arrivals.rbegin()->first;
  for (const auto& [gid, end] : ends_by_writer_) {
    if (end->is_client_ || end->service_ != requests.service) continue;
    const std::uint64_t* const last_taken = end->last_taken_.find(writer);
    taken_by_all = std::min(taken_by_all, last_taken == nullptr ? 0 : *last_taken);
  }
  const auto first_kept = arrivals.upper_bound(taken_by_all);
  arrivals_ -= static_cast<std::size_t>(std::distance(arrivals.begin(), first_kept));
  arrivals.erase(arrivals.begin(), first_kept);
}

bool ServiceForms::is_of_inline_peer(const Address& address) {
  if (!has_inline_peers_) return false;
  const std::lock_guard lock(mutex_);
  const auto participant = addresses_.participant_at(address);
  return participant && uses_inline_form(*participant);
}

bool ServiceForms::discovers(const Address& address) {
  if (!has_inline_peers_) return false;
  constexpr std::uint8_t first_multicast = 224;
  constexpr std::uint8_t multicast_of_v6 = 0xff;
  const bool is_v4 = std::all_of(address.bytes.begin(), address.bytes.begin() + 12, [](auto byte) { return byte == 0; });
  if (is_v4 ? address.bytes[12] >= first_multicast : address.bytes[0] == multicast_of_v6) return true;
  const std::lock_guard lock(mutex_);
  const auto participant = discovery_addresses_.participant_at(address);
  return participant && uses_inline_form(*participant);
}

void ServiceForms::set_content_filter(const Gid& reader, ContentFilter filter) {
  const std::lock_guard lock(mutex_);
  content_filters_[reader] = std::move(filter);
}

void ServiceForms::clear_content_filter(const Gid& reader) {
  if (is_abandoned_) return;
  const std::lock_guard lock(mutex_);
  content_filters_.erase(reader);
}

std::optional<std::vector<std::byte>> ServiceForms::complete(Bytes datagram) {
  const std::lock_guard lock(mutex_);
  return with_participants(datagram, content_filters_);
}

std::optional<Gid> ServiceForms::inline_client(const std::array<std::uint8_t, 8>& key) {
  const std::lock_guard lock(mutex_);
  const auto client = inline_clients_.find(key);
  if (client == inline_clients_.end()) return std::nullopt;
  return client->second;
}

bool ServiceForms::knows(const GuidPrefix& participant) {
  const std::lock_guard lock(mutex_);
  return addresses_.knows(participant);
}

void ServiceForms::forget(const GuidPrefix& participant) {
  const Gid first = gid_of(participant, EntityId{});
  const Gid last = gid_of(participant, EntityId{0xff, 0xff, 0xff, 0xff});
  const std::lock_guard lock(mutex_);
  addresses_.erase(participant);
  discovery_addresses_.erase(participant);
  versions_.erase(participant);
  beginnings_.erase_range_if(first, last, [](const Gid&, const Beginning&) { return true; });
  keys_.erase_range_if(first, last, [this](const Gid&, const auto& key) { return inline_clients_.erase(key) != 0; });
  for (const auto& [gid, end] : ends_by_writer_) {
    if (end->is_client_) continue;
    // Which request of a writer was taken last matters while others wait.
    end->last_taken_.erase_range_if(
        first, last, [this](const Gid& writer, auto) { return requests_.find(writer) == nullptr; });
  }
}

std::size_t ServiceForms::remembered() {
  const std::lock_guard lock(mutex_);
  std::size_t count = beginnings_.size() + keys_.size() + inline_clients_.size() + requests_.size();
  for (const auto& [gid, end] : ends_by_writer_) count += end->last_taken_.size() + end->responses_.size();
  return count;
}

std::string ServiceForms::version_of(const GuidPrefix& participant) {
  const std::lock_guard lock(mutex_);
  return versions_.of(participant);
}

ServiceEnd* ServiceForms::end_of(const EntityId& writer, const GuidPrefix& participant) {
  const auto end = ends_by_writer_.find(gid_of(participant, writer));
  return end == ends_by_writer_.end() ? nullptr : end->second;
}

bool ServiceForms::rewrite(const Address& address, Bytes datagram, std::vector<std::vector<std::byte>>& rewritten) {
  auto message = Message::of(datagram);
  if (!message) return false;
  const GuidPrefix source = message->source();
  const std::lock_guard lock(mutex_);
  const auto participant = addresses_.participant_at(address);
  if (!participant || !uses_inline_form(*participant)) return false;

  bool is_changed = false;
  Bytes destination;  // the last info_dst and info_ts, which hold for what follows
  Bytes stamp;
  std::vector<std::byte> out(message->header().begin(), message->header().end());
  std::size_t empty_size = out.size();  // without submessages of a writer
  // Rewritten submessages are larger, and may exceed what one datagram holds. Each further datagram starts with the
  // same header, destination and stamp.
  const auto start_datagram = [&] {
    rewritten.push_back(std::move(out));
    out.assign(message->header().begin(), message->header().end());
    append(out, destination);
    append(out, stamp);
    empty_size = out.size();
  };
  while (const auto submessage = message->next()) {
    if (submessage->kind == Kind::info_dst) destination = submessage->bytes;
    if (submessage->kind == Kind::info_ts) stamp = submessage->bytes;
    const auto data = Data::of(*submessage);
    ServiceEnd* end = data ? end_of(data->writer, source) : nullptr;
    const std::size_t former_size = out.size();
    if (end != nullptr) {
      is_changed = append_rewritten(*end, *participant, *submessage, *data, out) || is_changed;
    } else if (submessage->kind == Kind::acknack && append_request(*participant, *submessage, out)) {
      is_changed = true;
    } else {
      append(out, submessage->bytes);
      if (submessage->kind == Kind::info_dst || submessage->kind == Kind::info_ts) {
        empty_size += former_size == empty_size ? submessage->bytes.size() : 0;
      }
    }
    // Move this submessage to a new datagram, unless it is too large by itself.
    if (out.size() > max_datagram_size && former_size > empty_size) {
      const std::vector<std::byte> last(out.begin() + static_cast<std::ptrdiff_t>(former_size), out.end());
      out.resize(former_size);
      start_datagram();
      append(out, last);
    }
  }
  if (!is_changed) {
    rewritten.clear();
    return false;
  }
  if (out.size() > empty_size) rewritten.push_back(std::move(out));
  return true;
}

// Append an acknowledgement that requests nothing as one that requests the first sample of a service's writer, if it has
// arrived and has not been taken: it was dropped, because the writer was not matched yet. Return false if it is another
// acknowledgement.
bool ServiceForms::append_request(const GuidPrefix& participant, const Submessage& acknack,
                                  std::vector<std::byte>& out) const {
  constexpr std::size_t bitmap_at = 24;  // after the ids, the base and the number of bits
  const Fields fields = acknack.fields();
  if (!fields.is_little_endian() || acknack.bytes.size() != bitmap_at + 4 || fields.u32(20) != 0) return false;
  const Beginning* const beginning = beginnings_.find(gid_of(participant, bytes_at<4>(acknack.bytes, 8)));
  if (beginning == nullptr || beginning->is_taken) return false;
  const std::uint64_t first = beginning->first;
  if (first == 0 || fields.sequence_number(12) > first) return false;
  const std::size_t start = out.size();
  append(out, acknack.bytes.first(bitmap_at));
  out.resize(out.size() + 4);
  append(out, acknack.bytes.subspan(bitmap_at));
  store(&out[start + 2], static_cast<std::uint16_t>(bitmap_at + 4));
  store_sequence_number(&out[start + 12], first);
  store(&out[start + 20], std::uint32_t{1});
  store(&out[start + bitmap_at], std::uint32_t{0x80000000});
  return true;
}

// Return the sample in header form that a fragment is of; null if it was not kept. `Writer::write` has kept it, when it
// had no sequence number yet. Its first fragment has the header, by which it is found; the later ones are found by the
// number.
const std::vector<std::byte>* ServiceEnd::kept_sample(const Data& fragment) {
  auto kept = std::ranges::find(kept_, fragment.sequence_number, &Kept::sequence_number);
  if (kept == kept_.end() && fragment.first_fragment == 1 && fragment.payload.size() >= header_end) {
    const ServiceHeader header = read_header(fragment.payload);
    kept = std::ranges::find_if(kept_, [&](const Kept& candidate) {
      return candidate.sequence_number == 0 && candidate.sample.size() == fragment.sample_size &&
             read_header(candidate.sample) == header;
    });
    if (kept != kept_.end()) kept->sequence_number = fragment.sequence_number;
  }
  return kept == kept_.end() ? nullptr : &kept->sample;
}

// Append a submessage of a service's writer in inline form, for a participant. Return false if it is appended as it is.
bool ServiceForms::append_rewritten(ServiceEnd& end, const GuidPrefix& participant, const Submessage& submessage,
                                    const Data& data, std::vector<std::byte>& out) {
  if (!data.is_little_endian || !data.is_sample) {
    append(out, submessage.bytes);
    return false;
  }
  // First, the sample's header, which goes into the inline QoS, and its content without that header.
  ServiceHeader header;
  std::vector<std::byte> fragment;  // of the sample in inline form
  Bytes payload[2];
  if (!data.is_fragment) {
    if (data.payload.size() < header_end) {
      append(out, submessage.bytes);
      return false;
    }
    header = read_header(data.payload);
    payload[0] = data.payload.first(encapsulation_size);
    payload[1] = data.payload.subspan(header_end);
  } else {
    // The inline form is shorter by the header, so each of its fragments has other bytes than the one of that number
    // here: it needs the whole sample.
    const std::vector<std::byte>* const sample = end.kept_sample(data);
    // A sample that was not kept had no reader then, so none of its fragments is for this peer.
    if (sample == nullptr) return true;
    header = read_header(*sample);
    fragment = inline_fragment(*sample, data);
    if (fragment.empty()) return true;  // the last one, which the shorter sample does not have, or none: number 0
    payload[0] = fragment;
  }
  // libddsc writes each response to every client of the service. The reader of a client on Fast DDS keeps ten samples
  // until they are taken: if other clients' responses filled it, they would replace the one that this client waits for,
  // and its call would never end.
  const auto related = related_to(end, participant, header);
  if (!related) {
    append_gap(out, data, bytes_at<4>(submessage.bytes, 8));
    return true;
  }
  if (end.is_client_) {
    // A response names the request's sequence number; the program identifies the request by the number in its header.
    end.request_numbers_[data.sequence_number] = header.number;
    erase_oldest(end.request_numbers_, max_sent);
  }

  // Then the submessage: its fixed fields, its inline QoS with one more parameter before the sentinel, and the content.
  const std::size_t start = out.size();
  append(out, submessage.bytes.first(data.inline_qos_at));
  if (!data.inline_qos.empty()) append(out, data.inline_qos.first(data.inline_qos.size() - 4));
  append(out, related_identity(*related));
  append(out, payload[0]);
  append(out, payload[1]);
  out[start + 1] |= std::byte{inline_qos_flag};
  const std::size_t size = out.size() - start - submessage_header_size;
  store(&out[start + 2], static_cast<std::uint16_t>(size <= 0xffff ? size : 0));  // 0: to the end of the message
  if (data.is_fragment) store(&out[start + 32], static_cast<std::uint32_t>(data.sample_size - ServiceHeader::size));
  return true;
}

// Return what a sample is related to, as its inline QoS names it. Of a request: the reader of its response. Of a response:
// the request; nullopt if its client is not in the participant.
std::optional<Related> ServiceForms::related_to(const ServiceEnd& end, const GuidPrefix& participant,
                                                const ServiceHeader& header) const {
  if (end.is_client_) return Related{end.reader_, unknown_sequence_number};
  const auto client = inline_clients_.find(header.client);
  if (client == inline_clients_.end() || prefix_of(client->second) != participant) return std::nullopt;
  return Related{client->second, static_cast<std::uint64_t>(header.number)};
}

}  // namespace tfloom::rtps
