#include "dds/flow_control.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include "dds/entity.hpp"

#ifdef __linux__
#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#endif

namespace tfloom::dds {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

// In a sleep of this time, which the timer of Linux makes half as long again, a receiver reads a few large datagrams.
constexpr microseconds pause{50};
// After it, others may have filled a socket that had room.
constexpr milliseconds max_age{5};
// Where no queue was ever known. The kernel looks for its module udp_diag at each question, for milliseconds.
constexpr milliseconds max_unknown_age{1000};
// Others send to the same socket, so a sender takes only this share of its room before it asks again.
constexpr std::size_t shares = 4;

// Return at least what the kernel counts for a datagram: its bytes, and what it needs to keep them.
std::size_t cost_of(std::size_t size) { return size + size / 16 + 2048; }

#ifdef __linux__
// Ask the kernel for the queues of sockets by sock_diag(7), which needs no privilege and names those of this network
// namespace.
class SystemSources : public FlowSources {
 public:
  ~SystemSources() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  std::optional<SocketQueue> queue(const rtps::Address& address) override {
    constexpr std::uint8_t loopback = 127;
    // Another machine's address would find a socket here that is bound to all addresses.
    if (!is_of_ipv4(address) || address.bytes[12] != loopback) return std::nullopt;
    // Not in the constructor: the process may have no descriptor left for a while.
    if (descriptor_ < 0) descriptor_ = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG);
    if (descriptor_ < 0 || !send_question(address)) return std::nullopt;
    // The kernel answers within the question. An answer that was left by an earlier question is of another socket.
    while (true) {
      const ssize_t size = ::recv(descriptor_, answer_.data(), answer_.size(), MSG_DONTWAIT);
      nlmsghdr header{};
      if (size < static_cast<ssize_t>(sizeof(header))) return std::nullopt;
      std::memcpy(&header, answer_.data(), sizeof(header));
      if (header.nlmsg_seq == number_) return read_socket_queue({answer_.data(), static_cast<std::size_t>(size)});
    }
  }

 private:
  static bool is_of_ipv4(const rtps::Address& address) {
    return std::all_of(address.bytes.begin(), address.bytes.begin() + 12, [](std::uint8_t byte) { return byte == 0; });
  }

  bool send_question(const rtps::Address& address) {
    struct {
      nlmsghdr header;
      inet_diag_req_v2 socket;
    } question{};
    question.header.nlmsg_len = sizeof(question);
    question.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
    question.header.nlmsg_flags = NLM_F_REQUEST;
    question.header.nlmsg_seq = ++number_;
    question.socket.sdiag_family = AF_INET;
    question.socket.sdiag_protocol = IPPROTO_UDP;
    question.socket.idiag_ext = 1 << (INET_DIAG_SKMEMINFO - 1);
    question.socket.idiag_states = std::numeric_limits<std::uint32_t>::max();
    question.socket.id.idiag_dport = htons(static_cast<std::uint16_t>(address.port));
    std::memcpy(question.socket.id.idiag_dst, address.bytes.data() + 12, 4);
    // Sockets that are bound to this interface, as tfloom's own (dds/loopback.hpp), are found by it alone, all others, too.
    constexpr std::uint32_t loopback_index = 1;  // in each network namespace
    question.socket.id.idiag_if = loopback_index;
    question.socket.id.idiag_cookie[0] = question.socket.id.idiag_cookie[1] = INET_DIAG_NOCOOKIE;
    return ::send(descriptor_, &question, sizeof(question), 0) == static_cast<ssize_t>(sizeof(question));
  }

  int descriptor_ = -1;
  std::uint32_t number_ = 0;  // of the last question
  std::array<std::byte, 1024> answer_{};
};
#else
class SystemSources : public FlowSources {
 public:
  std::optional<SocketQueue> queue(const rtps::Address&) override { return std::nullopt; }
};
#endif

}  // namespace

#ifdef __linux__
std::optional<SocketQueue> read_socket_queue(std::span<const std::byte> answer) {
  nlmsghdr header{};
  if (answer.size() < sizeof(header)) return std::nullopt;
  std::memcpy(&header, answer.data(), sizeof(header));
  if (header.nlmsg_type != SOCK_DIAG_BY_FAMILY) return std::nullopt;  // an error: there is no such socket
  const std::size_t size = std::min<std::size_t>(answer.size(), header.nlmsg_len);
  std::size_t at = NLMSG_HDRLEN + NLMSG_ALIGN(sizeof(inet_diag_msg));
  while (at + sizeof(rtattr) <= size) {
    rtattr attribute{};
    std::memcpy(&attribute, answer.data() + at, sizeof(attribute));
    if (attribute.rta_len < sizeof(attribute) || at + attribute.rta_len > size) break;
    std::array<std::uint32_t, SK_MEMINFO_RCVBUF + 1> counts{};
    if (attribute.rta_type == INET_DIAG_SKMEMINFO && attribute.rta_len >= RTA_LENGTH(sizeof(counts))) {
      std::memcpy(counts.data(), answer.data() + at + RTA_LENGTH(0), sizeof(counts));
      return SocketQueue{counts[SK_MEMINFO_RMEM_ALLOC], counts[SK_MEMINFO_RCVBUF]};
    }
    at += RTA_ALIGN(attribute.rta_len);
  }
  return std::nullopt;
}
#endif

std::unique_ptr<FlowSources> FlowSources::of_system() { return std::make_unique<SystemSources>(); }

FlowControl& FlowControl::of_process() {
  // Never destroyed, as of `ServiceForms`. A forked child's own has a separate socket: both would read the answers of one.
  // Without a lock, which a thread of the parent may hold.
  struct OfProcess {
    FlowControl flow_control{FlowSources::of_system()};
    const std::int64_t process = process_id();
  };
  static std::atomic<OfProcess*> current = nullptr;
  OfProcess* found = current;
  if (found != nullptr && found->process == process_id()) return found->flow_control;
  auto made = std::make_unique<OfProcess>();
  if (current.compare_exchange_strong(found, made.get())) return made.release()->flow_control;
  return found->flow_control;  // that of another thread, which came first
}

bool FlowControl::wait_for_room(const rtps::Address& receiver, std::size_t size) {
  const std::size_t cost = cost_of(size);
  const auto begin = sources_->now();
  auto last_read = begin;
  std::size_t last_used = 0;
  while (true) {
    std::size_t used = 0;
    const std::optional<bool> room = has_room(receiver, cost, used);
    if (!room) return false;
    if (*room) return true;
    const auto now = sources_->now();
    // Compared with the last look, because others fill the socket while the receiver reads.
    if (used < last_used) last_read = now;
    last_used = used;
    if (now - last_read >= patience || now - begin >= longest_wait) {
      give_up(receiver, now - last_read >= patience ? used : 0);
      return true;
    }
    sources_->sleep(pause);
  }
}

std::optional<bool> FlowControl::has_room(const rtps::Address& receiver, std::size_t cost, std::size_t& used) {
  const std::lock_guard lock(mutex_);
  Flow& flow = flows_.use(receiver);
  const auto age = sources_->now() - flow.asked;
  // Of an address without a socket of this machine: one may come, of a process that was killed and started again.
  const milliseconds max_age_here = is_answered_ ? max_age : max_unknown_age;
  if (!flow.is_known && flow.asked != FlowSources::Clock::time_point{} && age < max_age_here) return std::nullopt;
  if (flow.room >= cost && age < max_age) {
    flow.room -= cost;
    return true;
  }
  const std::optional<SocketQueue> queue = sources_->queue(receiver);
  flow.asked = sources_->now();
  flow.is_known = queue.has_value();
  flow.room = 0;
  if (!queue) {
    flow.is_given_up = false;  // whoever has this address later is another one
    return std::nullopt;
  }
  is_answered_ = true;
  used = queue->used;
  if (used < flow.given_up_at) flow.is_given_up = false;
  // The kernel takes any datagram into an empty socket.
  if (used > 0 && used + cost > queue->limit) {
    if (flow.given_up_at > 0) flow.given_up_at = std::max(flow.given_up_at, used);  // the last one was taken, too
    return flow.is_given_up;
  }
  flow.is_given_up = false;
  if (used + cost <= queue->limit) flow.room = (queue->limit - used - cost) / shares;
  return true;
}

void FlowControl::give_up(const rtps::Address& receiver, std::size_t used) {
  const std::lock_guard lock(mutex_);
  Flow& flow = flows_.use(receiver);
  flow.is_given_up = true;
  flow.given_up_at = used;
}

}  // namespace tfloom::dds
