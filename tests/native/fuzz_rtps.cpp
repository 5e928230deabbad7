// Fuzzes what is read from the datagrams of DDS for the two forms of services: addresses, requests, responses.
//
// An input: what to do with the datagram, which stamp a taken sample has; then the datagram. First, datagrams with known
// answers. For the arguments, see fuzzing.hpp.
#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "fuzzing.hpp"
#include "rtps/service_forms.hpp"

namespace {

using namespace tfloom;
using rtps::Bytes;
using rtps::ServiceEnd;
using rtps::ServiceForms;
using Datagram = std::vector<std::byte>;
using Datagrams = std::vector<Datagram>;

constexpr std::size_t head = 2;
constexpr int inputs_per_target = 256;
constexpr std::array<std::uint8_t, 8> key = {'c', 'l', 'i', 'e', 'n', 't', ' ', '1'};

// Participants of ours and of Fast DDS, and an endpoint of each.
constexpr Gid our_writer = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 1, 3};
constexpr Gid our_reader = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 2, 4};
constexpr Gid server_writer = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 3, 3};
constexpr Gid server_reader = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 4, 4};
constexpr Gid fast_writer = {1, 0x0f, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 5, 3};
constexpr Gid fast_reader = {1, 0x0f, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 6, 4};
const rtps::Address fast_address = {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 127, 0, 0, 1}, 7421};
const rtps::Address other_address = {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 127, 0, 0, 1}, 7423};

void check(bool holds, const char* what) {
  if (!holds) fuzzing::fail("fuzz_rtps", what);
}

// Little-endian messages.
class Builder {
 public:
  explicit Builder(const Gid& source) {
    text("RTPS").bytes({2, 3, source[0], source[1]});
    for (std::size_t i = 0; i < 12; ++i) bytes({source[i]});
  }

  Builder& bytes(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::byte>(value));
    return *this;
  }
  Builder& text(std::string_view value) {
    for (const char character : value) bytes_.push_back(static_cast<std::byte>(character));
    return *this;
  }
  Builder& u16(unsigned value) { return bytes({int(value & 0xff), int(value >> 8 & 0xff)}); }
  Builder& u32(std::uint32_t value) { return u16(value & 0xffff).u16(value >> 16); }
  Builder& gid(const Gid& value) {
    for (const int octet : value) bytes({octet});
    return *this;
  }
  Builder& stamp(std::uint32_t seconds) { return bytes({9, 1}).u16(8).u32(seconds).u32(0); }

  Builder& begin(int kind, int flags) {
    bytes({kind, flags}).u16(0);
    start_ = bytes_.size();
    return *this;
  }
  Builder& end() {
    const std::size_t size = bytes_.size() - start_;
    bytes_[start_ - 2] = static_cast<std::byte>(size & 0xff);
    bytes_[start_ - 1] = static_cast<std::byte>(size >> 8);
    return *this;
  }
  Builder& data(const Gid& writer, std::uint32_t number, bool has_inline_qos) {
    begin(0x15, has_inline_qos ? 7 : 5).u16(0).u16(16).u32(0);
    return bytes({writer[12], writer[13], writer[14], writer[15]}).u32(0).u32(number);
  }
  Builder& related(const Gid& value, std::uint32_t high, std::uint32_t low) {
    return u16(0x83).u16(24).gid(value).u32(high).u32(low).u16(1).u16(0);
  }
  Builder& header(std::uint32_t number) {
    for (const int octet : key) bytes({octet});
    return u32(number).u32(0);
  }
  Builder& encapsulation() { return bytes({0, 1, 0, 0}); }

  operator const Datagram&() const { return bytes_; }
  operator Bytes() const { return bytes_; }

 private:
  Datagram bytes_;
  std::size_t start_ = 0;
};

Builder announcement(const Gid& source, std::uint32_t port) {
  Builder message(source);
  message.begin(0x15, 5).u16(0).u16(16).u32(0).bytes({0, 1, 0, 0xc2}).u32(0).u32(1);
  message.bytes({0, 3, 0, 0}).u16(0x31).u16(24).u32(1).u32(port).u32(0).u32(0).u32(0).bytes({127, 0, 0, 1});
  return message.u16(1).u16(0).end();
}

Builder writer_announcement(const Gid& writer) {
  Builder message(writer);
  message.begin(0x15, 5).u16(0).u16(16).u32(0).bytes({0, 0, 3, 0xc2}).u32(0).u32(1).bytes({0, 3, 0, 0});
  message.u16(5).u16(8).u32(4).text("rq/").bytes({0}).u16(0x5a).u16(16).gid(writer);
  return message.u16(1).u16(0).end();
}

// A participant's announcement with a parameter of its vendor.
Builder version_announcement(const Gid& source, unsigned id, const Datagram& value) {
  Builder message(source);
  message.begin(0x15, 5).u16(0).u16(16).u32(0).bytes({0, 1, 0, 0xc2}).u32(0).u32(1).bytes({0, 3, 0, 0});
  message.u16(id).u16(static_cast<unsigned>(value.size()));
  for (const std::byte octet : value) message.bytes({std::to_integer<int>(octet)});
  return message.u16(1).u16(0).end();
}

// The text of Cyclone DDS, after five numbers, as libddsc 11.0.1 sends it; its length counts a zero.
Datagram cyclone_info(std::string_view text) {
  Builder info(our_writer);
  info.u32(0).u32(0).u32(0).u32(0).u32(0).u32(static_cast<std::uint32_t>(text.size() + 1)).text(text).bytes({0});
  const Datagram& bytes = info;
  return {bytes.begin() + rtps::message_header_size, bytes.end()};
}

Builder inline_request(std::uint32_t number, std::uint32_t seconds) {
  return Builder(fast_writer).stamp(seconds).data(fast_writer, number, true).related(fast_reader, 0xffffffff, 0)
      .encapsulation().text("ask!").end();
}

// A datagram in a larger buffer, as a socket fills it.
Datagram received(ServiceForms& forms, const Datagram& datagram) {
  Datagram buffer = datagram;
  buffer.resize(datagram.size() + 4096);
  buffer.resize(forms.receive(buffer, datagram.size()));
  return buffer;
}

struct Target {
  ServiceForms forms;
  std::shared_ptr<ServiceEnd> client = forms.add_client("/s", our_writer, our_reader, key);
  std::shared_ptr<ServiceEnd> server = forms.add_server("/s", server_writer, server_reader);
  int inputs = 0;

  Target() {
    forms.read_versions();
    received(forms, announcement(fast_writer, fast_address.port));
  }
};

bool contains(const Datagram& datagram, const Datagram& part) {
  return !std::ranges::search(datagram, part).empty();
}

Datagram tail(const Datagram& datagram) { return {datagram.begin() + rtps::message_header_size, datagram.end()}; }

void check_known_answers() {
  Target target;
  ServiceForms& forms = target.forms;
  check(forms.is_of_inline_peer(fast_address) && !forms.is_of_inline_peer(other_address), "which addresses are Fast DDS's");
  check(forms.knows(rtps::prefix_of(fast_writer)), "a participant's address is known");

  // A request of ours, to Fast DDS and to others; its response.
  const Datagram request = Builder(our_writer).stamp(5).data(our_writer, 3, false).encapsulation().header(11).text("ask!").end();
  Datagrams sent;
  check(!forms.rewrite(other_address, request, sent) && sent.empty(), "others get the header form");
  check(forms.rewrite(fast_address, request, sent) && sent.size() == 1, "Fast DDS gets one datagram");
  check(sent[0] == Datagram(Builder(our_writer).stamp(5).data(our_writer, 3, true).related(our_reader, 0xffffffff, 0)
                                .encapsulation().text("ask!").end()),
        "a request in inline form");
  received(forms, Builder(fast_writer).stamp(6).data(fast_writer, 1, true).related(our_reader, 0, 3).encapsulation()
                    .text("say!").end());
  check(!target.client->take_header(fast_writer, 7'000'000'000), "a response of another time");
  check(target.client->take_header(fast_writer, 6'000'000'001) == rtps::ServiceHeader{key, 11}, "a response's header");
  check(!target.client->take_header(fast_writer, 6'000'000'000), "a header is taken once");

  // A request of Fast DDS; the response to it, and one to a client of the header form.
  received(forms, inline_request(2, 8));
  const auto asked = target.server->take_header(fast_writer, 8'000'000'000);
  check(asked && asked->number == 2 && forms.inline_client(asked->client) == fast_reader, "a request's header");
  Builder response(server_writer);
  response.data(server_writer, 1, false).encapsulation();
  Datagram bytes = response;
  rtps::append(bytes, *asked);
  bytes[22] = std::byte{40};  // the length of the submessage
  sent.clear();
  check(forms.rewrite(fast_address, bytes, sent) && sent.size() == 1 &&
            contains(sent[0], tail(Builder(our_writer).related(fast_reader, 0, 2))),
        "a response names its request");
  sent.clear();
  // A gap of one sequence number: no reader of this participant awaits the sample.
  const Datagram gap =
      tail(Builder(our_writer).begin(8, 1).u16(0).u16(0).bytes({0, 0, 3, 3}).u32(0).u32(2).u32(0).u32(3).u32(0).end());
  check(forms.rewrite(fast_address, Builder(server_writer).data(server_writer, 2, false).encapsulation().header(9).end(), sent) &&
            sent.size() == 1 && tail(sent[0]) == gap,
        "a response to others is a gap");

  // Another participant on Fast DDS, whose readers await none of it.
  Gid neighbour = fast_writer;
  neighbour[3] = 1;
  received(forms, announcement(neighbour, other_address.port));
  sent.clear();
  Datagram gap_of_first = gap;
  gap_of_first[16] = std::byte{1};  // the sequence number, and where what follows begins
  gap_of_first[24] = std::byte{2};
  check(forms.rewrite(other_address, bytes, sent) && sent.size() == 1 && tail(sent[0]) == gap_of_first,
        "a response to a client of another participant is a gap");

  // A sample in fragments of 32 bytes: 20 + 60 in header form, so three; in inline form 64, so two.
  Datagram sample = Builder(our_writer).encapsulation().header(12);
  sample.erase(sample.begin(), sample.begin() + rtps::message_header_size);
  for (int i = 0; i < 60; ++i) sample.push_back(static_cast<std::byte>(i));
  target.client->keep(sample);
  Datagram joined;
  for (std::size_t fragment = 0; fragment * 32 < sample.size(); ++fragment) {
    Builder message(our_writer);
    message.begin(0x16, 1).u16(0).u16(28).u32(0).bytes({0, 0, 1, 3}).u32(0).u32(4);
    message.u32(static_cast<std::uint32_t>(fragment + 1)).u16(1).u16(32).u32(static_cast<std::uint32_t>(sample.size()));
    for (std::size_t at = fragment * 32; at < std::min(sample.size(), fragment * 32 + 32); ++at) {
      message.bytes({std::to_integer<int>(sample[at])});
    }
    sent.clear();
    check(forms.rewrite(fast_address, message.end(), sent), "a fragment is rewritten");
    check(sent.size() == (fragment < 2 ? 1 : 0), "the shorter sample has one fragment less");
    if (sent.empty()) continue;
    const Datagram& whole = sent[0];
    auto view = rtps::Message::of(whole);
    const auto data = rtps::Data::of(*view->next());
    check(data && data->sample_size == 64 && data->first_fragment == fragment + 1, "a fragment's fields");
    joined.insert(joined.end(), data->payload.begin(), data->payload.end());
  }
  sample.erase(sample.begin() + 4, sample.begin() + 20);
  check(joined == sample, "the fragments in inline form");
  target.client->release();
  check(target.client->kept_size() == 0, "kept samples are released");

  Builder unkept(our_writer);
  unkept.begin(0x16, 1).u16(0).u16(28).u32(0).bytes({0, 0, 1, 3}).u32(0).u32(5).u32(1).u16(1).u16(32).u32(80);
  sent.clear();
  check(forms.rewrite(fast_address, unkept.encapsulation().header(13).text("0123456789ab").end(), sent) && sent.empty(),
        "no fragment of a sample that was not kept is sent");

  // A writer whose samples nobody has taken yet: where they begin, and which are missing.
  Target fresh;
  received(fresh.forms, writer_announcement(fast_writer));
  const auto heartbeat = [](std::uint32_t first, std::uint32_t last, int flags) {
    return tail(Builder(our_writer).begin(7, flags).u32(0).bytes({0, 0, 5, 3}).u32(0).u32(first).u32(0).u32(last)
                    .u32(last + 1).end());
  };
  check(received(fresh.forms, inline_request(4, 8)).size() == Datagram(inline_request(4, 8)).size() + 32 &&
            contains(received(fresh.forms, inline_request(4, 8)), heartbeat(4, 3, 3)),
        "a beginning");
  const auto acknowledgement = [](std::uint32_t base, bool requests) {
    Builder message(our_reader);
    message.begin(6, 1).bytes({0, 0, 4, 4, 0, 0, 5, 3}).u32(0).u32(base).u32(requests ? 1 : 0);
    return (requests ? message.u32(0x80000000) : message).u32(77).end();
  };
  sent.clear();
  check(fresh.forms.rewrite(fast_address, acknowledgement(1, false), sent) &&
            sent == Datagrams{acknowledgement(4, true)},
        "the first sample is requested");
  sent.clear();
  check(fresh.forms.rewrite(fast_address, acknowledgement(4, false), sent) && sent == Datagrams{acknowledgement(4, true)},
        "the first sample is requested by who awaits it");
  sent.clear();
  check(!fresh.forms.rewrite(fast_address, acknowledgement(5, false), sent), "an acknowledgement stays");
  check(contains(received(fresh.forms, inline_request(5, 8)), heartbeat(4, 4, 1)), "one missing sample is requested");
  const Datagram later = received(fresh.forms, inline_request(6, 9));
  check(contains(later, heartbeat(4, 3, 3)) && contains(later, heartbeat(4, 5, 1)), "the missing samples");
  check(fresh.server->take_header(fast_writer, 8'000'000'000).has_value(), "a first request");
  check(received(fresh.forms, inline_request(7, 9)) == Datagram(inline_request(7, 9)), "nothing is inserted later");
  sent.clear();
  check(!fresh.forms.rewrite(fast_address, acknowledgement(1, false), sent), "nothing is requested later");

  // An IPv4 locator whose unused bytes are not zero; the name of a topic without its length, beside what follows.
  Datagram odd = announcement(fast_writer, other_address.port);
  odd[odd.size() - 20] = std::byte{1};
  received(fresh.forms, odd);
  check(fresh.forms.is_of_inline_peer(other_address), "the unused bytes of an IPv4 address count for nothing");
  constexpr Gid late_writer = {1, 0x0f, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 9, 3};
  Datagram nameless = writer_announcement(late_writer);
  const std::array<std::byte, 4> length = {std::byte{4}, std::byte{0}, std::byte{0}, std::byte{0}};
  std::ranges::search(nameless, length).front() = std::byte{0};
  const std::size_t remembered = fresh.forms.remembered();
  received(fresh.forms, nameless);
  check(fresh.forms.remembered() == remembered, "a name of no length is empty");
  received(fresh.forms, writer_announcement(late_writer));
  check(fresh.forms.remembered() == remembered + 1, "a writer of a service is remembered");

  // Another program takes the address.
  received(forms, announcement(our_writer, fast_address.port));
  check(!forms.is_of_inline_peer(fast_address), "an address follows its owner");
  check(!forms.knows(rtps::prefix_of(fast_writer)), "a participant without an address is not known");
}

Builder inline_response(std::uint32_t number, std::uint32_t seconds, std::uint32_t request) {
  return Builder(fast_writer).stamp(seconds).data(fast_writer, number, true).related(our_reader, 0, request)
      .encapsulation().text("say!").end();
}

constexpr std::int64_t second_ns = 1'000'000'000;

// Let a client's request number 11 pass, as sample 3.
void send_request(ServiceForms& forms) {
  Datagrams sent;
  const Datagram request = Builder(our_writer).data(our_writer, 3, false).encapsulation().header(11).text("ask!").end();
  check(forms.rewrite(fast_address, request, sent), "a request is rewritten");
}

void check_beginnings() {
  const auto heartbeat = [](std::uint32_t first, std::uint32_t last, int flags) {
    return Builder(fast_writer).begin(7, flags).u32(0).bytes({0, 0, 5, 3}).u32(0).u32(first).u32(0).u32(last)
        .u32(last + 1).end();
  };
  Target target;
  ServiceForms& forms = target.forms;
  received(forms, writer_announcement(fast_writer));
  check(contains(received(forms, inline_request(6, 8)), tail(heartbeat(6, 5, 3))), "the beginning at a first sample");
  check(contains(received(forms, inline_request(4, 8)), tail(heartbeat(4, 3, 3))), "the beginning at an earlier one");
  check(contains(received(forms, heartbeat(9, 12, 1)), tail(heartbeat(9, 8, 3))), "what has gone is not awaited");
  check(contains(received(forms, heartbeat(2, 12, 1)), tail(heartbeat(4, 3, 3))), "what was dropped is awaited");

  check(received(forms, inline_request(0, 8)) == Datagram(inline_request(0, 8)), "no sample has the number 0");

  // Two samples in one datagram: what is inserted stands before its own sample, the beginning first.
  Target pair;
  received(pair.forms, writer_announcement(fast_writer));
  Datagram two = inline_request(4, 8);
  const Datagram second = tail(inline_request(6, 8));
  two.insert(two.end(), second.begin(), second.end());
  constexpr std::size_t stamp_size = 12;
  Datagram expected(two.begin(), two.begin() + rtps::message_header_size + stamp_size);
  const auto append = [&expected](const Datagram& part) { expected.insert(expected.end(), part.begin(), part.end()); };
  append(tail(heartbeat(4, 3, 3)));
  append(tail(Builder(fast_writer).data(fast_writer, 4, true).related(fast_reader, 0xffffffff, 0).encapsulation().text("ask!").end()));
  append({second.begin(), second.begin() + stamp_size});
  append(tail(heartbeat(4, 3, 3)));
  append(tail(heartbeat(4, 5, 1)));
  append({second.begin() + stamp_size, second.end()});
  check(received(pair.forms, two) == expected, "two samples of a datagram");

  // A relayed message has another source than its header says.
  Target relayed;
  Datagram relay = Builder(fast_writer).begin(0x0c, 1).u32(0).bytes({2, 3, 1, 15}).u32(9).u32(9).u32(9).end();
  relay.insert(relay.end(), second.begin(), second.end());
  received(relayed.forms, relay);
  check(!relayed.server->take_header(fast_writer, 8 * second_ns), "a relayed sample is nobody's");

  // A buffer without room for a heartbeat is left as it is; ASan looks beyond its end.
  Datagram full = inline_request(7, 9);
  check(forms.receive(full, full.size()) == full.size() && full == Datagram(inline_request(7, 9)), "a full buffer");

  Target fresh;
  send_request(fresh.forms);
  received(fresh.forms, inline_response(1, 5, 3));
  check(fresh.client->take_header(fast_writer, 5 * second_ns).has_value(), "a first response");
  const Datagram later = inline_response(2, 6, 3);
  check(received(fresh.forms, later) == later, "nothing is inserted after a response was taken");
}

void check_order_and_ends() {
  Target target;
  ServiceForms& forms = target.forms;
  send_request(forms);
  for (const std::uint32_t number : {1U, 2U, 3U}) received(forms, inline_response(number, number, 3));
  check(target.client->take_header(fast_writer, 2 * second_ns).has_value(), "a response");
  check(!target.client->take_header(fast_writer, 1 * second_ns), "those before a response that was taken are over");
  check(target.client->take_header(fast_writer, 3 * second_ns).has_value(), "the response after it");

  // Two servers of a service in this process, each of which takes a request once.
  constexpr Gid other_writer = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 7, 3};
  constexpr Gid other_reader = {1, 0x10, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 0, 0, 8, 4};
  std::shared_ptr<ServiceEnd> other = forms.add_server("/s", other_writer, other_reader);
  received(forms, inline_request(4, 8));
  check(target.server->take_header(fast_writer, 8 * second_ns).has_value(), "a request");
  check(!target.server->take_header(fast_writer, 8 * second_ns), "a request is taken once by a server");
  check(other->take_header(fast_writer, 8 * second_ns).has_value(), "a request is taken by each server");
  received(forms, inline_request(5, 9));
  check(target.server->take_header(fast_writer, 9 * second_ns).has_value(), "a next request");
  other.reset();
  other = forms.add_server("/s", other_writer, other_reader);
  check(!other->take_header(fast_writer, 9 * second_ns), "what all that were there have taken is forgotten");

  // A participant leaves while one of two servers has yet to take its request: the other does not get it again.
  received(forms, inline_request(6, 10));
  check(target.server->take_header(fast_writer, 10 * second_ns).has_value(), "a request before its client leaves");
  forms.forget(rtps::prefix_of(fast_writer));
  check(!forms.is_of_inline_peer(fast_address), "the address of a participant that has left is known");
  check(!target.server->take_header(fast_writer, 10 * second_ns), "a request of a client that has left comes once");
  check(other->take_header(fast_writer, 10 * second_ns).has_value(), "a request of a client that has left");

  // Ends that leave while others stay, and what arrives for them then.
  other.reset();
  target.server.reset();
  check(forms.has_ends(), "a client is left");
  target.client.reset();
  check(!forms.has_ends(), "no end is left");
  const auto late = forms.add_server("/s", server_writer, server_reader);
  received(forms, inline_response(9, 9, 3));
  Target parents;  // of a forked child
  parents.forms.abandon();
  parents.client.reset();
  parents.server.reset();
  check(parents.forms.has_ends(), "an object that was abandoned is left as it is");
}

void check_what_is_forgotten() {
  Target target;
  ServiceForms& forms = target.forms;
  send_request(forms);
  received(forms, writer_announcement(fast_writer));
  const std::size_t at_first = forms.remembered();
  received(forms, inline_response(1, 1, 3));
  check(target.client->take_header(fast_writer, second_ns).has_value(), "a response");
  check(forms.remembered() == at_first, "a response that was taken is remembered");

  received(forms, inline_request(2, 2));
  check(target.server->take_header(fast_writer, 2 * second_ns).has_value(), "a request");
  const std::size_t of_client = forms.remembered();
  const auto other = forms.add_server("/t", Gid{1, 0x10, 7, 9}, Gid{1, 0x10, 7, 10});
  received(forms, inline_request(3, 3));
  check(target.server->take_header(fast_writer, 3 * second_ns).has_value(), "a next request");
  check(forms.remembered() == of_client, "a request that its servers have taken waits for another service's");
}

void check_bounds() {
  Target target;
  ServiceForms& forms = target.forms;
  Datagrams sent;
  constexpr std::uint32_t more_than_sent = 1100;
  for (std::uint32_t number = 1; number <= more_than_sent; ++number) {
    forms.rewrite(fast_address, Builder(our_writer).data(our_writer, number, false).encapsulation().header(number).end(),
                  sent);
  }
  received(forms, inline_response(1, 5, 1));
  check(!target.client->take_header(fast_writer, 5 * second_ns), "the first of many requests is remembered");
  received(forms, inline_response(2, 6, more_than_sent));
  check(target.client->take_header(fast_writer, 6 * second_ns).has_value(), "the last of many requests is forgotten");

  const auto participant = [](std::uint32_t number) {
    Gid gid = fast_writer;
    gid[3] = 1;  // none is that of the target
    gid[4] = static_cast<std::uint8_t>(number >> 8);
    gid[5] = static_cast<std::uint8_t>(number);
    return gid;
  };
  for (std::uint32_t number = 0; number <= rtps::max_addresses; ++number) {
    received(forms, announcement(participant(number), 10'000 + number));
  }
  check(!forms.knows(rtps::prefix_of(fast_writer)) && !forms.knows(rtps::prefix_of(participant(0))),
        "of many addresses the first are remembered");
  check(forms.knows(rtps::prefix_of(participant(1))), "of many addresses too many are forgotten");
  for (std::uint32_t number = 0; number <= 1024; ++number) {
    received(forms, version_announcement(participant(number), 0x8000, Datagram(4, std::byte{3})));
  }
  check(forms.version_of(rtps::prefix_of(participant(0))).empty(), "of many versions the first is remembered");
  check(!forms.version_of(rtps::prefix_of(participant(1024))).empty(), "of many versions the last is forgotten");
}

void check_large_datagrams() {
  Target target;
  Datagrams sent;
  const auto sample = [](std::uint32_t number, std::size_t size) {
    return Builder(our_writer).data(our_writer, number, false).encapsulation().header(number).text(std::string(size, 'x'));
  };
  // One that is too large in inline form: there is nothing to divide. Its length doesn't fit its field either.
  Datagram large = sample(3, 65'500);
  large[22] = large[23] = std::byte{0};  // to the end of the message
  check(target.forms.rewrite(fast_address, large, sent) && sent.size() == 1, "one large sample is one datagram");
  const auto data = rtps::Data::of(*rtps::Message::of(sent[0])->next());
  check(data && data->payload.size() == 65'504, "a sample of any length");

  // Two that fit in header form alone: each has a datagram, with the destination and the stamp of the first.
  Datagram two = Builder(our_writer).begin(0x0e, 1).gid(fast_writer).end().stamp(5);
  two.resize(rtps::message_header_size + 16);  // the destination is a prefix
  two[rtps::message_header_size + 2] = std::byte{12};
  const Datagram stamp = tail(Builder(our_writer).stamp(5));
  const Datagram destination = tail(two);
  two.insert(two.end(), stamp.begin(), stamp.end());
  for (const std::uint32_t number : {4U, 5U}) {
    const Datagram part = tail(sample(number, 32'670).end());
    two.insert(two.end(), part.begin(), part.end());
  }
  sent.clear();
  check(two.size() <= 65'507 && target.forms.rewrite(fast_address, two, sent) && sent.size() == 2, "two datagrams");
  for (const Datagram& datagram : sent) {
    Datagram begin = destination;
    begin.insert(begin.end(), stamp.begin(), stamp.end());
    check(contains(datagram, begin), "each datagram has its destination and stamp");
  }

  // Two answers to one request, in fragments: each fragment is of its own sample.
  target.client->release();
  Datagrams samples;
  for (const char fill : {'a', 'b'}) {
    samples.push_back(tail(Builder(our_writer).encapsulation().header(12).text(std::string(60, fill))));
    target.client->keep(samples.back());
  }
  check(target.client->kept_size() == 160, "the size of all that is kept");
  for (const std::uint32_t number : {6U, 7U}) {
    const Datagram& whole = samples[number - 6];
    Builder message(our_writer);
    message.begin(0x16, 1).u16(0).u16(28).u32(0).bytes({0, 0, 1, 3}).u32(0).u32(number);
    message.u32(1).u16(1).u16(32).u32(static_cast<std::uint32_t>(whole.size()));
    for (std::size_t at = 0; at < 32; ++at) message.bytes({std::to_integer<int>(whole[at])});
    sent.clear();
    check(target.forms.rewrite(fast_address, message.end(), sent) && sent.size() == 1 &&
              sent[0].back() == std::byte{static_cast<unsigned char>(number == 6 ? 'a' : 'b')},
          "a fragment of its own sample");
  }
}

void check_versions() {
  constexpr unsigned of_fast = 0x8000, of_cyclone = 0x8007;
  Target target;
  ServiceForms& forms = target.forms;
  const auto announced = [&forms](const Gid& source, unsigned id, const Datagram& value) {
    received(forms, version_announcement(source, id, value));
    return forms.version_of(rtps::prefix_of(source));
  };
  const Datagram four = {std::byte{3}, std::byte{2}, std::byte{10}, std::byte{0}};
  check(announced(our_writer, of_cyclone, cyclone_info("no version")).empty(), "a text without a version");
  check(announced(our_writer, of_cyclone, cyclone_info("host/11.0.1")).empty(), "a text that ends early");
  check(announced(our_writer, of_cyclone, cyclone_info("host/\x1b[2J/Linux/x86")).empty(), "a version with controls");
  check(announced(our_writer, of_cyclone, cyclone_info("host/" + std::string(99, '1') + "/a/b")).empty(), "a long version");
  Datagram cut = cyclone_info("host/11.0.1/Linux/x86");
  cut.resize(24);
  check(announced(our_writer, of_cyclone, cut).empty(), "a text longer than its parameter");
  check(announced(our_writer, of_fast, four).empty(), "another vendor's parameter");
  check(announced(fast_writer, of_fast, {four.begin(), four.begin() + 3}).empty(), "three bytes of four");
  check(announced(our_writer, of_cyclone, cyclone_info("host/11.0.1/Linux/x86")) == "11.0.1", "Cyclone's version");
  check(announced(fast_writer, of_fast, four) == "3.2.10.0", "the version of Fast DDS");
  ServiceForms deaf;
  received(deaf, version_announcement(our_writer, of_cyclone, cyclone_info("host/11.0.1/Linux/x86")));
  check(deaf.version_of(rtps::prefix_of(our_writer)).empty(), "versions are read on request");
}

// The parameter that names a participant, as libddsc's announcements of endpoints lack it.
Builder& participant_of(Builder& message, const Gid& endpoint) {
  Gid participant = endpoint;
  const Gid entity = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0xc1};
  std::copy(entity.begin() + 12, entity.end(), participant.begin() + 12);
  return message.u16(0x50).u16(16).gid(participant);
}

// A reader's or a writer's announcement, with its participant or without.
Builder endpoint_announcement(const Gid& endpoint, int kind, bool has_participant, int flags = 5) {
  Builder message(endpoint);
  message.stamp(5).begin(0x15, flags).u16(0).u16(16).u32(0).bytes({0, 0, kind, 0xc2}).u32(0).u32(1).bytes({0, 3, 0, 0});
  message.u16(5).u16(8).u32(4).text("rt/").bytes({0}).u16(0x5a).u16(16).gid(endpoint);
  if (has_participant) participant_of(message, endpoint);
  return message.u16(1).u16(0).end();
}

void check_participants() {
  for (const int kind : {3, 4}) {
    const Datagram whole = endpoint_announcement(our_writer, kind, true);
    const auto completed = rtps::with_participants(endpoint_announcement(our_writer, kind, false));
    check(completed.has_value() && *completed == whole, "an announced endpoint names its participant");
    check(!rtps::with_participants(whole), "it names it once");
  }
  check(!rtps::with_participants(endpoint_announcement(our_writer, 0, false)), "a participant's list is no endpoint's");
  check(!rtps::with_participants(endpoint_announcement(our_writer, 3, false, 9)), "a key announces nothing");
  check(!rtps::with_participants(announcement(our_writer, 7421)), "a participant's announcement stays");
  check(!rtps::with_participants(Builder(our_writer).stamp(5).data(our_writer, 3, false).encapsulation().end()),
        "a sample stays");
  Datagram open = endpoint_announcement(our_writer, 3, false);
  open.resize(open.size() - 4);  // without the sentinel, to which the length still extends
  check(!rtps::with_participants(open), "a list without an end stays");
  Datagram relayed = Builder(our_writer).begin(0x0c, 1).u32(0).bytes({2, 1, 1, 0x10}).u32(7).u32(7).u32(7).end();
  const Datagram behind = endpoint_announcement(our_writer, 3, false);
  relayed.insert(relayed.end(), behind.begin() + 20, behind.end());
  check(!rtps::with_participants(relayed), "the endpoint of another participant stays");

  // A filter follows the participant, for the announcement of its reader alone.
  const rtps::ContentFilters filters = {{our_writer, {"rt/x", "data > %0", {"5", "'a'"}}}};
  const Datagram filtered = *rtps::with_participants(endpoint_announcement(our_writer, 4, false), filters);
  const Datagram plain = endpoint_announcement(our_writer, 4, true);
  Builder value(our_writer);
  value.begin(0x15, 5).u16(0x35).u16(80);
  value.u32(14).text("rt/x_filtered").bytes({0, 0, 0}).u32(5).text("rt/x").bytes({0, 0, 0, 0}).u32(7).text("DDSSQL");
  value.bytes({0, 0}).u32(10).text("data > %0").bytes({0, 0, 0}).u32(2).u32(2).text("5").bytes({0, 0, 0});
  value.u32(4).text("'a'").bytes({0});
  const Datagram whole_value = value.end();
  const Datagram parameter(whole_value.begin() + 24, whole_value.end());
  check(filtered.size() == plain.size() + parameter.size(), "a filter is added to a reader's announcement");
  check(std::equal(parameter.begin(), parameter.end(), filtered.end() - 4 - static_cast<std::ptrdiff_t>(parameter.size())),
        "as the standard has it");
  const Datagram writers = *rtps::with_participants(endpoint_announcement(our_writer, 3, false), filters);
  check(writers == Datagram(endpoint_announcement(our_writer, 3, true)), "a writer has no filter");
  const Datagram others = *rtps::with_participants(endpoint_announcement(fast_writer, 4, false), filters);
  check(others == Datagram(endpoint_announcement(fast_writer, 4, true)), "nor has another reader");
  const rtps::ContentFilters huge = {{our_writer, {"rt/x", std::string(70'000, 'x'), {}}}};
  check(*rtps::with_participants(endpoint_announcement(our_writer, 4, false), huge) == plain, "one that is too long is not sent");

  const rtps::Address discovery = {fast_address.bytes, 7410};
  const rtps::Address group = {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 239, 255, 0, 1}, 7400};
  ServiceForms forms;
  check(!forms.discovers(group), "nobody is told without Fast DDS");
  Builder located(fast_writer);
  located.begin(0x15, 5).u16(0).u16(16).u32(0).bytes({0, 1, 0, 0xc2}).u32(0).u32(1).bytes({0, 3, 0, 0});
  located.u16(0x32).u16(24).u32(1).u32(7410).u32(0).u32(0).u32(0).bytes({127, 0, 0, 1}).u16(1).u16(0).end();
  received(forms, located);
  check(forms.discovers(discovery) && forms.discovers(group), "Fast DDS is told at its address and by multicast");
  check(!forms.discovers(fast_address) && !forms.is_of_inline_peer(discovery), "samples have another address");
}

bool run(std::span<const std::uint8_t> bytes) {
  static std::optional<Target> target;
  if (!target || target->inputs >= inputs_per_target) target.emplace();
  ++target->inputs;
  if (bytes.size() < head) return false;
  // A copy that ends with its allocation, so that the sanitizer sees one byte too many.
  Datagram datagram(bytes.size() - head);
  if (!datagram.empty()) std::memcpy(datagram.data(), bytes.data() + head, datagram.size());
  Datagrams sent;
  if (bytes[0] % 2 == 0) {
    received(target->forms, datagram);
    const std::int64_t stamp_ns = std::int64_t{bytes[1]} * 1'000'000'000;
    check(target->forms.version_of(rtps::prefix_of(our_writer)).size() <= 32, "a version is short");
    const bool was_taken = target->server->take_header(fast_writer, stamp_ns).has_value();
    return target->client->take_header(fast_writer, stamp_ns).has_value() || was_taken;
  }
  if (const auto completed = rtps::with_participants(datagram)) {
    check(completed->size() > datagram.size() && completed->size() <= 2 * datagram.size(), "participants are added");
    check(!rtps::with_participants(*completed), "participants are added once");
  }
  if (bytes[1] % 8 == 0) target->client->keep(datagram);
  const bool is_rewritten = target->forms.rewrite(fast_address, datagram, sent);
  std::size_t size = 0;
  for (const Datagram& part : sent) {
    size += part.size();
    check(part.size() <= 65'507 || sent.size() == 1, "a datagram is too large");
  }
  check(is_rewritten || sent.empty(), "what is sent as it is has no other form");
  check(size < 4 * datagram.size() + 4096 || bytes[1] % 8 == 0, "the inline form grows");
  return is_rewritten;
}

fuzzing::Bytes seed(int action, int stamp_s, const Datagram& datagram) {
  fuzzing::Bytes bytes = {static_cast<std::uint8_t>(action), static_cast<std::uint8_t>(stamp_s)};
  for (const std::byte octet : datagram) bytes.push_back(std::to_integer<std::uint8_t>(octet));
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  check_known_answers();
  check_versions();
  check_beginnings();
  check_order_and_ends();
  check_what_is_forgotten();
  check_bounds();
  check_large_datagrams();
  check_participants();
  const fuzzing::Bytes request =
      seed(1, 1, Builder(our_writer).stamp(5).data(our_writer, 3, false).encapsulation().header(11).text("ask!").end());
  const fuzzing::Bytes response = seed(0, 6, Builder(fast_writer).stamp(6).data(fast_writer, 1, true)
                                                 .related(our_reader, 0, 3).encapsulation().text("say!").end());
  return fuzzing::fuzz("fuzz_rtps", run,
                       {request, response, seed(0, 8, inline_request(2, 8)), seed(0, 0, announcement(fast_writer, 7421)),
                        seed(0, 0, writer_announcement(fast_writer)), seed(1, 1, endpoint_announcement(our_writer, 3, false)),
                        seed(0, 0, version_announcement(our_writer, 0x8007, cyclone_info("host/11.0.1/Linux/x86"))),
                        seed(0, 0, version_announcement(fast_writer, 0x8000, Datagram(4)))},
                       count, arguments);
}
