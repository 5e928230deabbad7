// Senders that wait for room in the sockets of receivers, by a kernel and a clock that the program makes itself, and by the
// system's. Returns 0 if nothing was sent into a full socket while its receiver read, and no sender waited for one that
// had stopped, or of which nothing is known; the sanitizer checks the rest.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#ifdef __linux__
#include <arpa/inet.h>
#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/resource.h>
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
  std::function<void()> on_sleep = [] {};  // what others do meanwhile
  bool takes_one_too_many = false;  // as kernels before 6.12: any datagram, as long as the limit isn't exceeded yet
  int questions = 0;
  int dropped = 0;

  class Sources : public FlowSources {
   public:
    explicit Sources(Receiver& receiver) : receiver_(receiver) {}
    std::optional<SocketQueue> queue(const Address&) override {
      ++receiver_.questions;
      receiver_.read(std::chrono::microseconds{1});  // while the kernel answers
      return receiver_.queue;
    }
    [[nodiscard]] Clock::time_point now() const override { return Clock::time_point(receiver_.now); }
    void sleep(std::chrono::microseconds time) const override {
      receiver_.waited += time;
      receiver_.pass(time);
      receiver_.on_sleep();
    }

   private:
    Receiver& receiver_;
  };

  std::unique_ptr<FlowSources> sources() { return std::make_unique<Sources>(*this); }

  void pass(std::chrono::microseconds time) {
    now += time;
    read(time);
  }

  void read(std::chrono::microseconds time) {
    if (!queue || period == 0us) return;
    for (unread += time; unread >= period; unread -= period) queue->used -= std::min(queue->used, counted);
  }

  void arrive() {
    pass(10us);
    if (!queue) return;
    if (queue->used + (takes_one_too_many ? 0 : counted) > queue->limit && queue->used > 0) {
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

void a_receiver_that_reads_again_is_waited_for_at_once() {
  Receiver receiver;
  receiver.takes_one_too_many = true;
  receiver.period = 0us;
  FlowControl flow(receiver.sources());
  receiver.send(flow, 100);
  check(receiver.waited >= FlowControl::patience, "a full socket was not waited for");
  // It goes on while a sender sends without a pause: the socket never gets room for another datagram by itself.
  receiver.period = 30us;
  receiver.dropped = 0;
  receiver.send(flow, 1000);
  check(receiver.dropped < 20, std::to_string(receiver.dropped) + " of 1000 were sent into a socket that is read again");
}

void a_sender_that_others_overtake_goes_on_waiting() {
  Receiver receiver;
  receiver.period = 0us;
  receiver.queue->used = receiver.queue->limit;
  FlowControl flow(receiver.sources());
  // Each time that a datagram is read, others fill the socket before this sender looks again, but for a small rest.
  std::uint32_t reads = 0;
  receiver.on_sleep = [&] {
    receiver.queue->used = receiver.queue->limit - (++reads % 2) * 1000;
    if (receiver.waited > 4 * FlowControl::patience) receiver.queue->used = 0;
  };
  receiver.send(flow, 1);
  check(receiver.waited > 4 * FlowControl::patience && receiver.dropped == 0, "a socket that was read was given up");
}

void a_sender_that_others_overtake_for_ever_goes_on() {
  Receiver receiver;
  receiver.period = 0us;
  receiver.queue->used = receiver.queue->limit;
  FlowControl flow(receiver.sources());
  std::uint32_t reads = 0;
  receiver.on_sleep = [&] { receiver.queue->used = receiver.queue->limit - (++reads % 2) * 1000; };
  receiver.send(flow, 1);
  check(receiver.waited >= FlowControl::longest_wait, "a sender that others overtake gave up early");
  check(receiver.waited < FlowControl::longest_wait + 1ms, "others stopped a sender");
  receiver.waited = 0us;
  receiver.queue->used = receiver.queue->limit - 2000;  // it is still read, and has no room
  receiver.send(flow, 100);
  check(receiver.waited == 0us, "others delayed a sender more than once");
  receiver.queue->used = 0;  // they end
  receiver.on_sleep = [] {};
  receiver.period = 30us;
  receiver.dropped = 0;
  receiver.send(flow, 100);
  check(receiver.waited > 0us && receiver.dropped == 0, "a socket that got room is not waited for again");
}

void a_receiver_that_leaves_is_not_waited_for() {
  Receiver receiver;
  receiver.period = 0us;
  receiver.queue->used = receiver.queue->limit;
  FlowControl flow(receiver.sources());
  receiver.on_sleep = [&] { receiver.queue.reset(); };  // its process is killed while the sender waits
  check(receiver.send(flow, 1) == 1, "a socket that was closed has a queue");
  check(receiver.waited < 1ms, "a sender waited for a receiver that had left");
}

void the_next_receiver_at_an_address_is_waited_for() {
  Receiver receiver;
  receiver.period = 0us;
  FlowControl flow(receiver.sources());
  receiver.send(flow, 100);  // the first one has stopped, and is given up
  const auto of_first = receiver.queue;
  receiver.queue.reset();  // it is killed
  receiver.now += 6ms;
  check(receiver.send(flow, 10) == 10, "a socket that was closed has a queue");
  receiver.now += 6ms;  // no longer than a process takes to start
  receiver.queue = of_first;  // which others have filled already
  receiver.period = 30us;
  receiver.dropped = 0;
  check(receiver.send(flow, 100) == 0, "a socket that was opened again soon stays unknown");
  check(receiver.dropped == 0, "the next receiver was taken for the one that had stopped");
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

// An answer of sock_diag(7), of two attributes: another one, and that with the counts.
std::vector<std::byte> answer_of(std::uint32_t used, std::uint32_t most) {
  struct {
    nlmsghdr header;
    inet_diag_msg socket;
    rtattr shutdown;
    std::uint32_t padded_byte;
    rtattr memory;
    std::uint32_t counts[9];
  } answer{};
  answer.header.nlmsg_len = sizeof(answer);
  answer.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
  answer.shutdown = {.rta_len = RTA_LENGTH(1), .rta_type = INET_DIAG_SHUTDOWN};
  answer.memory = {.rta_len = RTA_LENGTH(sizeof(answer.counts)), .rta_type = INET_DIAG_SKMEMINFO};
  answer.counts[SK_MEMINFO_RMEM_ALLOC] = used;
  answer.counts[SK_MEMINFO_RCVBUF] = most;
  std::vector<std::byte> bytes(sizeof(answer));
  std::memcpy(bytes.data(), &answer, sizeof(answer));
  return bytes;
}

void answers_are_read_in_bounds() {
  using tfloom::dds::read_socket_queue;
  const std::vector<std::byte> whole = answer_of(5, limit);
  const auto queue = read_socket_queue(whole);
  check(queue && queue->used == 5 && queue->limit == limit, "an answer was not understood");
  // Each in memory of its own size, by which the sanitizer finds what is read beyond it.
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    const auto of_cut = read_socket_queue(cut);
    check(!of_cut || of_cut->limit == limit, "an answer that was cut off has another limit");
  }
  check(!read_socket_queue(std::span(whole).first(whole.size() - 24)), "an answer without the limit has one");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int value : {0, 1, 3, 127, 255}) {
      std::vector<std::byte> hostile = whole;
      hostile[at] = static_cast<std::byte>(value);
      static_cast<void>(read_socket_queue(hostile));
    }
  }
  std::vector<std::byte> refused = whole;
  const std::uint16_t error = NLMSG_ERROR;
  std::memcpy(refused.data() + offsetof(nlmsghdr, nlmsg_type), &error, sizeof(error));
  check(!read_socket_queue(refused), "a refusal has a queue");
}

// Return the descriptor that the next one to be opened will have.
int next_descriptor() {
  const int next = ::dup(0);
  ::close(next);
  return next;
}

void a_left_answer_is_dropped() {
  const Unread unread;
  const std::unique_ptr<FlowSources> sources = FlowSources::of_system();
  const int descriptor = next_descriptor();
  if (!sources->queue(unread.port())) return;  // as in `the_kernel_tells`
  struct {
    nlmsghdr header;
    inet_diag_req_v2 socket;
  } question{};  // of no socket
  question.header.nlmsg_len = sizeof(question);
  question.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
  question.header.nlmsg_flags = NLM_F_REQUEST;
  question.header.nlmsg_seq = 7;
  question.socket.sdiag_family = AF_INET;
  question.socket.sdiag_protocol = IPPROTO_UDP;
  check(::send(descriptor, &question, sizeof(question), 0) == ssize_t{sizeof(question)},
        "this is not the socket that is asked");
  check(sources->queue(unread.port()).has_value(), "the answer to an earlier question was taken for that to this one");
  check(sources->queue(unread.port()).has_value(), "an answer was left for the next question");
}

void a_process_without_descriptors_asks_later() {
  const Unread unread;
  const std::unique_ptr<FlowSources> sources = FlowSources::of_system();
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const rlimit none{0, before.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &none);
  check(!sources->queue(unread.port()), "a process without a descriptor got an answer");
  ::setrlimit(RLIMIT_NOFILE, &before);
  check(sources->queue(unread.port()).has_value() == FlowSources::of_system()->queue(unread.port()).has_value(),
        "a process that had no descriptor for a while never asks");
}

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
  const char loopback[] = "lo";
  check(::setsockopt(of_all_addresses.descriptor, SOL_SOCKET, SO_BINDTODEVICE, loopback, sizeof(loopback)) == 0 &&
            sources->queue(of_all_addresses.port()).has_value(),
        "a socket that is bound to the loopback interface has no queue");
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
  a_receiver_that_reads_again_is_waited_for_at_once();
  a_sender_that_others_overtake_goes_on_waiting();
  a_sender_that_others_overtake_for_ever_goes_on();
  a_receiver_that_leaves_is_not_waited_for();
  the_next_receiver_at_an_address_is_waited_for();
  a_slow_receiver_is_waited_for();
  a_small_socket_gets_one_at_a_time();
  an_unknown_queue_is_not_waited_for();
  threads_send_to_many();
#ifdef __linux__
  answers_are_read_in_bounds();
  a_left_answer_is_dropped();
  a_process_without_descriptors_asks_later();
  the_kernel_tells();
#endif
  return faults == 0 ? 0 : 1;
}
