// Senders that wait for room in the sockets of receivers, by a kernel and a clock that the program makes itself, and by the
// system's. Returns 0 if nothing was sent into a full socket while its receiver read, and no sender waited for one that
// had stopped, or of which nothing is known; the sanitizer checks the rest.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#ifdef __linux__
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include "checks.hpp"
#include "dds/flow_control.hpp"

using namespace std::chrono_literals;
using tfloom::dds::FlowControl;
using tfloom::dds::FlowSources;
using tfloom::dds::SocketQueue;
using tfloom::rtps::Address;

namespace {

constexpr std::size_t datagram = 65'000;
constexpr std::uint32_t counted = 65'832;  // by the kernel, for such a datagram
constexpr std::uint32_t limit = 425'984;   // of a socket of the default size

Address address_of(std::uint32_t port) {
  Address address;
  address.bytes[12] = 127;
  address.bytes[15] = 1;
  address.port = port;
  return address;
}

// A socket whose receiver reads a datagram each `period`, by a clock that advances while a sender sleeps.
struct Receiver {
  std::optional<SocketQueue> queue = SocketQueue{0, limit};
  std::chrono::microseconds period{30};
  std::chrono::microseconds now{1s};
  std::chrono::microseconds waited{0};
  std::chrono::microseconds unread{0};
  int questions = 0;
  int dropped = 0;

  class Sources : public FlowSources {
   public:
    explicit Sources(Receiver& receiver) : receiver_(receiver) {}
    std::optional<SocketQueue> queue(const Address&) override {
      ++receiver_.questions;
      return receiver_.queue;
    }
    [[nodiscard]] Clock::time_point now() const override { return Clock::time_point(receiver_.now); }
    void sleep(std::chrono::microseconds time) const override {
      receiver_.waited += time;
      receiver_.pass(time);
    }

   private:
    Receiver& receiver_;
  };

  std::unique_ptr<FlowSources> sources() { return std::make_unique<Sources>(*this); }

  void pass(std::chrono::microseconds time) {
    now += time;
    if (!queue || period == 0us) return;
    for (unread += time; unread >= period; unread -= period) queue->used -= std::min(queue->used, counted);
  }

  void arrive() {
    pass(10us);
    if (!queue) return;
    if (queue->used + counted > queue->limit && queue->used > 0) {
      ++dropped;
    } else {
      queue->used += counted;
    }
  }

  // Send so many datagrams; return how many were told of as sent without knowledge of the queue.
  int send(FlowControl& flow, int count) {
    int unknown = 0;
    for (int i = 0; i < count; ++i) {
      if (!flow.wait_for_room(address_of(7411), datagram)) ++unknown;
      arrive();
    }
    return unknown;
  }
};

void nothing_is_lost_while_the_receiver_reads() {
  Receiver receiver;
  FlowControl flow(receiver.sources());
  check(receiver.send(flow, 1000) == 0, "a known queue was taken for an unknown one");
  check(receiver.dropped == 0, std::to_string(receiver.dropped) + " of 1000 datagrams were sent into a full socket");
  check(receiver.waited < 40ms, "a sender waited longer than the receiver read");
}

void a_large_socket_costs_few_questions() {
  Receiver receiver;
  receiver.queue->limit = 8 << 20;
  FlowControl flow(receiver.sources());
  receiver.send(flow, 120);
  check(receiver.waited == 0us, "a sender waited for a socket with room");
  check(receiver.questions < 20, std::to_string(receiver.questions) + " questions for 120 datagrams");
}

void room_is_forgotten() {
  Receiver receiver;
  receiver.queue->limit = 8 << 20;
  FlowControl flow(receiver.sources());
  receiver.send(flow, 1);
  receiver.queue->used = receiver.queue->limit;  // by another sender
  receiver.now += 6ms;
  receiver.send(flow, 1);
  check(receiver.waited > 0us && receiver.dropped == 0, "the room of six milliseconds ago was used");
}

void a_stopped_receiver_delays_once() {
  Receiver receiver;
  receiver.period = 0us;
  FlowControl flow(receiver.sources());
  receiver.send(flow, 1000);
  check(receiver.waited >= FlowControl::patience, "a full socket was not waited for");
  check(receiver.waited < FlowControl::patience + 1ms, "a stopped receiver delayed a sender more than once");
  receiver.period = 30us;  // it goes on
  receiver.pass(1ms);
  receiver.dropped = 0;
  receiver.send(flow, 100);
  check(receiver.dropped == 0, "a receiver that had stopped is not waited for again");
  receiver.period = 0us;  // a second time
  receiver.waited = 0us;
  receiver.send(flow, 100);
  check(receiver.waited >= FlowControl::patience, "a receiver that stops again was not waited for");
}

void a_slow_receiver_is_waited_for() {
  Receiver receiver;
  receiver.period = 20ms;  // less than the patience
  FlowControl flow(receiver.sources());
  receiver.send(flow, 50);
  check(receiver.dropped == 0, "a slow receiver was given up");
}

void a_small_socket_gets_one_at_a_time() {
  Receiver receiver;
  receiver.queue->limit = 2304;  // the least of Linux
  FlowControl flow(receiver.sources());
  receiver.send(flow, 50);
  check(receiver.dropped == 0, "a datagram was sent into a small socket that was not empty");
  check(receiver.waited < FlowControl::patience, "a small socket stopped the sender");
}

void an_unknown_queue_is_not_waited_for() {
  Receiver receiver;
  receiver.queue.reset();
  FlowControl flow(receiver.sources());
  check(receiver.send(flow, 100) == 100, "an unknown queue was taken for a known one");
  check(receiver.waited == 0us, "a sender waited for an unknown queue");
  check(receiver.questions == 1, "an unknown queue was asked for again at once");
  receiver.queue = SocketQueue{0, limit};  // a socket is opened
  receiver.now += 2s;
  check(receiver.send(flow, 1) == 0, "a socket that was opened later stays unknown");
}

class ManyReceivers : public FlowSources {
 public:
  std::optional<SocketQueue> queue(const Address& address) override {
    ++questions_;  // without a lock: one thread asks at a time
    if (address.port % 3 == 0) return std::nullopt;
    return SocketQueue{address.port % 5 == 0 ? limit : 0, limit};
  }
  void sleep(std::chrono::microseconds) const override { std::this_thread::yield(); }

 private:
  int questions_ = 0;
};

void threads_send_to_many() {
  FlowControl flow(std::make_unique<ManyReceivers>());
  std::vector<std::thread> threads;
  for (std::uint32_t first = 0; first < 4; ++first) {
    threads.emplace_back([&flow, first] {
      for (std::uint32_t i = 0; i < 3000; ++i) flow.wait_for_room(address_of(1 + first + i % 4), datagram);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

#ifdef __linux__
// A socket of loopback that nobody reads, and its port.
struct Unread {
  int descriptor = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};

  explicit Unread(in_addr_t bound_to = INADDR_LOOPBACK) {
    const int size = 212'992;
    ::setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &size, sizeof(size));
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(bound_to);
    ::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof(address));
    socklen_t length = sizeof(address);
    ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &length);
  }
  Unread(const Unread&) = delete;
  Unread& operator=(const Unread&) = delete;
  ~Unread() { ::close(descriptor); }

  [[nodiscard]] Address port() const { return address_of(ntohs(address.sin_port)); }

  void fill() const {
    const std::vector<char> bytes(datagram);
    for (int i = 0; i < 20; ++i) {
      ::sendto(descriptor, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
    }
  }
};

void the_kernel_tells() {
  const Unread unread;
  const std::unique_ptr<FlowSources> sources = FlowSources::of_system();
  const auto empty = sources->queue(unread.port());
  if (!empty) {
    std::fprintf(stderr, "this kernel has no udp_diag: its answers are not tested\n");
    return;
  }
  check(empty->used == 0 && empty->limit > 0, "an empty socket is not told of as empty");
  unread.fill();
  const auto full = sources->queue(unread.port());
  check(full && full->used > 0 && full->used + counted > full->limit, "a full socket is not told of as full");
  check(!sources->queue(address_of(1)), "a port without a socket has a queue");
  const Unread of_all_addresses(INADDR_ANY);
  check(sources->queue(of_all_addresses.port()).has_value(), "a socket of all addresses has no queue");
  Address elsewhere = of_all_addresses.port();
  elsewhere.bytes[12] = 10;
  check(!sources->queue(elsewhere), "an address of another machine has a queue");
  Address of_v6 = unread.port();
  of_v6.bytes[0] = 1;
  check(!sources->queue(of_v6), "an address of IPv6 has the queue of IPv4");

  FlowControl& flow = FlowControl::of_process();
  check(&flow == &FlowControl::of_process(), "the process has two");
  const auto begin = std::chrono::steady_clock::now();
  check(flow.wait_for_room(unread.port(), datagram), "the queue of a socket is unknown");
  check(std::chrono::steady_clock::now() - begin >= FlowControl::patience, "a full socket was not waited for");
  const pid_t child = ::fork();
  if (child == 0) {
    const bool is_separate = &FlowControl::of_process() != &flow;
    const Unread another;
    ::_exit(is_separate && FlowControl::of_process().wait_for_room(another.port(), datagram) ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  check(status == 0, "a forked child shares its parent's questions");
}
#endif

}  // namespace

int main() {
  nothing_is_lost_while_the_receiver_reads();
  a_large_socket_costs_few_questions();
  room_is_forgotten();
  a_stopped_receiver_delays_once();
  a_slow_receiver_is_waited_for();
  a_small_socket_gets_one_at_a_time();
  an_unknown_queue_is_not_waited_for();
  threads_send_to_many();
#ifdef __linux__
  the_kernel_tells();
#endif
  return faults == 0 ? 0 : 1;
}
