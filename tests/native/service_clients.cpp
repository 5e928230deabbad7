// A server and the clients on Fast DDS that have called it: many that come and leave, and one that stays.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

#include "checks.hpp"
#include "rtps/recent_map.hpp"
#include "rtps/service_forms.hpp"

using namespace tfloom;
using namespace tfloom::rtps;

namespace {

constexpr std::uint32_t client_count = 70'000;  // more than are remembered

class Datagram {
 public:
  Datagram& bytes(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::byte>(value));
    return *this;
  }
  Datagram& u32(std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes_.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
    return *this;
  }
  template <typename Range>
  Datagram& range(const Range& values) {
    for (const auto value : values) bytes_.push_back(static_cast<std::byte>(value));
    return *this;
  }
  std::vector<std::byte> bytes_;
};

Gid gid_of_client(std::uint32_t number, std::uint8_t entity_kind) {
  return {0x01, 0x0f, static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
          static_cast<std::uint8_t>(number), 1, 2, 3, 4, 5, 6, 7, 0, 0, 5, entity_kind};
}

// A request: its sequence number is also its stamp [s].
std::vector<std::byte> request(std::uint32_t client, std::uint32_t number) {
  const Gid writer = gid_of_client(client, 0x03);
  Datagram datagram;
  datagram.range(std::string_view("RTPS")).bytes({2, 3, 1, 15});
  for (int i = 0; i < 12; ++i) datagram.bytes({writer[static_cast<std::size_t>(i)]});
  datagram.bytes({9, 1, 8, 0}).u32(number).u32(0);
  datagram.bytes({0x15, 7, 56, 0, 0, 0, 16, 0}).u32(0);
  for (std::size_t i = 12; i < 16; ++i) datagram.bytes({writer[i]});
  datagram.u32(0).u32(number);
  datagram.bytes({0x83, 0, 24, 0}).range(gid_of_client(client, 0x04)).u32(0xffffffff).u32(0).bytes({1, 0, 0, 0});
  datagram.bytes({0, 1, 0, 0});
  return datagram.bytes_;
}

class Server {
 public:
  Server() : end_(forms_.add_server("/s", Gid{1, 16, 7, 3}, Gid{1, 16, 7, 4})) {}

  void receive(std::uint32_t client, std::uint32_t number) {
    const auto datagram = request(client, number);
    std::memcpy(buffer_.data(), datagram.data(), datagram.size());
    forms_.receive(buffer_, datagram.size());
  }

  // The participant of a client leaves.
  void forget(std::uint32_t client) { forms_.forget(prefix_of(gid_of_client(client, 0x03))); }

  std::size_t remembered() { return forms_.remembered(); }

  bool take(std::uint32_t client, std::uint32_t number) {
    const auto header = end_->take_header(gid_of_client(client, 0x03), std::int64_t{number} * 1'000'000'000);
    if (header) last_key_ = header->client;
    return header && header->number == number;
  }

  // The key of the client whose request was taken last, and whether responses to it find it.
  std::array<std::uint8_t, 8> last_key() const { return last_key_; }
  bool knows(const std::array<std::uint8_t, 8>& key) { return forms_.inline_client(key).has_value(); }

 private:
  ServiceForms forms_;
  std::shared_ptr<ServiceEnd> end_;
  std::array<std::uint8_t, 8> last_key_{};
  std::array<std::byte, 4096> buffer_{};
};

void serve_all_that_come() {
  Server server;
  constexpr std::uint32_t waiting_client = client_count;
  server.receive(waiting_client, 1);
  int lost = 0;
  std::array<std::uint8_t, 8> first_key{};
  for (std::uint32_t client = 0; client < client_count; ++client) {
    server.receive(client, 1);
    lost += server.take(client, 1) ? 0 : 1;
    if (client == 0) first_key = server.last_key();
  }
  check(lost == 0, "requests of new clients were lost");
  check(server.knows(server.last_key()), "the last client is not known");
  check(!server.knows(first_key), "the first client is known for ever");
  check(server.take(waiting_client, 1), "a request that waited beside those that were taken was lost");
}

// Forged datagrams of clients whose requests nobody takes displace one another.
void serve_one_among_many() {
  Server server;
  constexpr std::uint32_t steady_client = client_count;
  int lost = 0;
  for (std::uint32_t client = 0; client < client_count; ++client) {
    server.receive(client, 1);
    if (client % 1000 != 0) continue;
    const std::uint32_t number = 1 + client / 1000;
    server.receive(steady_client, number);
    lost += server.take(steady_client, number) ? 0 : 1;
  }
  check(lost == 0, "requests of the client that stays were lost");
  check(!server.take(0, 1), "the client that was silent longest is remembered");
  check(server.take(client_count - 1, 1), "the last client is not remembered");
}

// A participant that leaves is forgotten; what it has sent before is still served.
void serve_those_that_have_left() {
  Server server;
  server.receive(1, 1);
  check(server.take(1, 1), "the request of a client that stays was lost");
  const std::size_t before = server.remembered();
  for (std::uint32_t client = 2; client < 1000; ++client) {
    server.receive(client, 1);
    server.receive(client, 2);
    check(server.take(client, 1), "a first request was lost");
    if (client % 2 == 0) check(server.take(client, 2), "a second request was lost");
    server.forget(client);
    check(server.take(client, 2) == (client % 2 != 0), "the request of a client that has left was lost, or came twice");
    server.forget(client);
  }
  check(server.remembered() == before, "clients that have left are remembered");
  server.receive(1, 2);
  check(server.take(1, 2), "a request of the client that stays was lost");
}

// One client that sends without end displaces its own requests.
void serve_another_beside_a_flood() {
  Server server;
  server.receive(1, 1);
  for (std::uint32_t number = 1; number <= 300'000; ++number) server.receive(2, number);
  check(server.take(1, 1), "the request before a flood was lost");
  // With those of two others, more wait than are remembered: the flood's own go, and no others with them.
  for (std::uint32_t number = 1; number <= 100'000; ++number) server.receive(3, number);
  server.receive(4, 1);
  server.receive(5, 1);
  check(!server.take(2, 300'000), "more requests are remembered than there is room for");
  check(server.take(3, 100'000) && server.take(4, 1) && server.take(5, 1), "too many requests were forgotten");
}

// A bounded map gives up what was not used for the longest time, and no more than it must.
void give_up_the_least_used() {
  RecentMap<int, int> map(2);
  map.use(1) = 10;
  map.use(2) = 20;
  check(map.size() == 2 && map.is_full(), "a map has room for fewer than its bound");
  map.use(1);
  map.use(3) = 30;
  check(map.size() == 2, "a map has more than its bound");
  check(map.find(2) == nullptr && map.find(1) != nullptr && map.find(3) != nullptr, "a used entry was given up");
}

// A server whose responses nobody takes displaces its own.
void be_answered_without_end() {
  constexpr Address address{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 127, 0, 0, 1}, 7421};
  constexpr Gid writer = {1, 16, 7, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 3};
  constexpr Gid reader = {1, 16, 7, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 4};
  ServiceForms forms;
  const auto client = forms.add_client("/s", writer, reader, {1, 2, 3, 4, 5, 6, 7, 8});
  std::array<std::byte, 4096> buffer{};
  const auto receive = [&](const Datagram& datagram) {
    std::memcpy(buffer.data(), datagram.bytes_.data(), datagram.bytes_.size());
    forms.receive(buffer, datagram.bytes_.size());
  };
  const Gid server = gid_of_client(1, 0x03);
  const auto from = [](const Gid& source) {
    Datagram datagram;
    datagram.range(std::string_view("RTPS")).bytes({2, 3, source[0], source[1]});
    for (std::size_t i = 0; i < 12; ++i) datagram.bytes({source[i]});
    return datagram;
  };
  // Where the server receives; then a request, sample 3.
  receive(from(server).bytes({0x15, 5, 56, 0, 0, 0, 16, 0}).u32(0).bytes({0, 1, 0, 0xc2}).u32(0).u32(1)
              .bytes({0, 3, 0, 0, 0x31, 0, 24, 0}).u32(1).u32(address.port).u32(0).u32(0).u32(0)
              .bytes({127, 0, 0, 1, 1, 0, 0, 0}));
  std::vector<std::vector<std::byte>> sent;
  const Datagram request = from(writer).bytes({0x15, 5, 44, 0, 0, 0, 16, 0}).u32(0).bytes({0, 0, 1, 3}).u32(0).u32(3)
                               .bytes({0, 1, 0, 0}).bytes({1, 2, 3, 4, 5, 6, 7, 8}).u32(11).u32(0).u32(0);
  check(forms.rewrite(address, request.bytes_, sent), "a request was not rewritten");
  constexpr std::uint32_t responses = 200'001;
  for (std::uint32_t number = 1; number <= responses; ++number) {
    receive(from(server).bytes({9, 1, 8, 0}).u32(number).u32(0).bytes({0x15, 7, 56, 0, 0, 0, 16, 0}).u32(0)
                .bytes({server[12], server[13], server[14], server[15]}).u32(0).u32(number)
                .bytes({0x83, 0, 24, 0}).range(reader).u32(0).u32(3).bytes({1, 0, 0, 0, 0, 1, 0, 0}));
  }
  const auto take = [&](std::uint32_t number) {
    const auto header = client->take_header(server, std::int64_t{number} * 1'000'000'000);
    return header && header->number == 11;
  };
  check(!take(1), "more responses are remembered than there is room for");
  check(take(2), "a response that there is room for was lost");
  check(take(responses), "the last response of a flood was lost");
}

// Of a probe: the heartbeats alone are changed, and nothing beyond the end of one that is cut off.
void ask_for_acknowledgements() {
  const auto probe = [](int final_and_not) {
    Datagram datagram;
    datagram.range(std::string_view("RTPS")).bytes({2, 1, 1, 16}).u32(1).u32(2).u32(3);
    datagram.bytes({9, 3, 0, 0});  // info_ts without a time
    datagram.bytes({0x15, 3, 28, 0, 0, 0, 16, 0}).u32(0).u32(0x03000005).u32(0).u32(7).bytes({1, 0, 0, 0}).u32(2);
    for (const int flags : {final_and_not, 1}) {
      datagram.bytes({7, flags, 28, 0}).u32(0).u32(0x03000005).u32(0).u32(1).u32(0).u32(7).u32(4);
    }
    datagram.bytes({6, 3, 4, 0}).u32(0);  // an acknowledgement, whose flag is another one
    return datagram.bytes_;
  };
  std::vector<std::byte> datagram = probe(3);
  request_acknowledgements(datagram);
  check(datagram == probe(1), "a heartbeat requests no acknowledgement, or something else was changed");
  for (std::size_t size = 0; size < datagram.size(); ++size) {
    std::vector<std::byte> cut = probe(3);
    cut.resize(size);
    cut.shrink_to_fit();
    request_acknowledgements(cut);
  }
}

}  // namespace

int main() {
  ask_for_acknowledgements();
  serve_all_that_come();
  serve_one_among_many();
  serve_another_beside_a_flood();
  serve_those_that_have_left();
  be_answered_without_end();
  give_up_the_least_used();
  std::printf("service clients: %d faults\n", faults.load());
  return faults == 0 ? 0 : 1;
}
