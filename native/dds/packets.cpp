#include "dds/packets.hpp"

#include "core/imports.hpp"

#ifdef __linux__
#include <dlfcn.h>
#include <link.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <chrono>
#include <cstring>
#include <optional>
#include <thread>
#include <vector>

#include "dds/flow_control.hpp"
#include "rtps/service_forms.hpp"
#endif

namespace tfloom::dds {
namespace {

thread_local bool requests_acknowledgements = false;

}  // namespace

AcknowledgementRequest::AcknowledgementRequest() { requests_acknowledgements = true; }
AcknowledgementRequest::~AcknowledgementRequest() { requests_acknowledgements = false; }

#ifdef __linux__
namespace {

std::optional<rtps::Address> address_of(const msghdr& message) {
  rtps::Address address;
  if (message.msg_name == nullptr) return std::nullopt;
  if (message.msg_namelen >= sizeof(sockaddr_in) && static_cast<sockaddr*>(message.msg_name)->sa_family == AF_INET) {
    sockaddr_in v4{};
    std::memcpy(&v4, message.msg_name, sizeof(v4));
    std::memcpy(address.bytes.data() + 12, &v4.sin_addr, sizeof(v4.sin_addr));
    address.port = ntohs(v4.sin_port);
    return address;
  }
  if (message.msg_namelen >= sizeof(sockaddr_in6) && static_cast<sockaddr*>(message.msg_name)->sa_family == AF_INET6) {
    sockaddr_in6 v6{};
    std::memcpy(&v6, message.msg_name, sizeof(v6));
    std::memcpy(address.bytes.data(), &v6.sin6_addr, sizeof(v6.sin6_addr));
    address.port = ntohs(v6.sin6_port);
    return address;
  }
  return std::nullopt;
}

std::size_t size_of(const msghdr& message) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(message.msg_iovlen); ++i) size += message.msg_iov[i].iov_len;
  return size;
}

// Wait before a large datagram that follows another one at once. For receivers whose sockets the kernel doesn't tell of.
// Fast DDS leaves its sockets at the system's default size, by which three datagrams of 64 kB wait on Linux; on loopback
// nothing else slows the sender down. The thread that receives takes one in some tens of microseconds.
void pace_by_time(std::size_t size) {
  using std::chrono::steady_clock;
  constexpr std::size_t min_size = 32 << 10;
  constexpr std::chrono::microseconds pause{100};  // the timer of Linux adds half of it
  thread_local steady_clock::time_point last_sent{};
  if (size < min_size) return;
  if (steady_clock::now() - last_sent < pause) std::this_thread::sleep_for(pause);
  last_sent = steady_clock::now();
}

// Wait before a large datagram until the receiver has room for it. Of its own accord only a small share of the messages of
// some megabytes arrives where sockets have the default size: benchmarks/node, "streams".
void pace(const rtps::Address& receiver, std::size_t size, bool is_of_inline_peer) {
  constexpr std::size_t min_size = 8 << 10;  // below that of the fragments for other machines
  if (size < min_size || FlowControl::of_process().wait_for_room(receiver, size)) return;
  if (is_of_inline_peer) pace_by_time(size);
}

std::vector<std::byte> joined(const msghdr& message) {
  std::vector<std::byte> datagram;
  for (std::size_t i = 0; i < static_cast<std::size_t>(message.msg_iovlen); ++i) {
    const auto* begin = static_cast<const std::byte*>(message.msg_iov[i].iov_base);
    datagram.insert(datagram.end(), begin, begin + message.msg_iov[i].iov_len);
  }
  return datagram;
}

// Send what announces endpoints with what libddsc leaves out; return nullopt for anything else, which is not sent.
std::optional<ssize_t> send_discovery(rtps::ServiceForms& forms, int descriptor, const msghdr& message, int flags) {
  constexpr std::size_t max_datagram = 65'507;  // of UDP
  const std::vector<std::byte> datagram = joined(message);
  std::optional<std::vector<std::byte>> completed = forms.complete(datagram);
  if (!completed || completed->size() > max_datagram) return std::nullopt;
  iovec part{completed->data(), completed->size()};
  msghdr replaced = message;
  replaced.msg_iov = &part;
  replaced.msg_iovlen = 1;
  return ::sendmsg(descriptor, &replaced, flags) < 0 ? -1 : static_cast<ssize_t>(datagram.size());
}

// Called by libddsc instead of sendmsg. Returns what sendmsg would: the number of bytes that libddsc passed, although
// fewer or more are sent.
ssize_t send(int descriptor, const msghdr* message, int flags) noexcept {
  rtps::ServiceForms& forms = rtps::ServiceForms::of_process();
  const auto address = address_of(*message);
  if (!address) return ::sendmsg(descriptor, message, flags);
  // Data may go to the addresses of discovery, too: to a multicast group.
  if (forms.discovers(*address)) {
    if (const auto sent = send_discovery(forms, descriptor, *message, flags)) return *sent;
  }
  const bool is_inline = forms.is_of_inline_peer(*address);
  pace(*address, size_of(*message), is_inline);
  const bool is_rewritten = is_inline && forms.has_ends();
  if (!is_rewritten && !requests_acknowledgements) return ::sendmsg(descriptor, message, flags);
  std::vector<std::byte> datagram = joined(*message);
  const std::size_t size = datagram.size();
  if (requests_acknowledgements) rtps::request_acknowledgements(datagram);
  std::vector<std::vector<std::byte>> replacements;
  if (!is_rewritten || !forms.rewrite(*address, datagram, replacements)) replacements.push_back(std::move(datagram));
  for (std::vector<std::byte>& replacement : replacements) {
    iovec part{replacement.data(), replacement.size()};
    msghdr replaced = *message;
    replaced.msg_iov = &part;
    replaced.msg_iovlen = 1;
    if (::sendmsg(descriptor, &replaced, flags) < 0) return -1;
  }
  return static_cast<ssize_t>(size);
}

// Called by libddsc instead of recvmsg.
ssize_t receive(int descriptor, msghdr* message, int flags) noexcept {
  const ssize_t size = ::recvmsg(descriptor, message, flags);
  if (size <= 0 || message->msg_iovlen != 1) return size;
  const std::span buffer(static_cast<std::byte*>(message->msg_iov[0].iov_base), message->msg_iov[0].iov_len);
  if (static_cast<std::size_t>(size) > buffer.size()) return size;  // cut off: MSG_TRUNC was set
  return static_cast<ssize_t>(rtps::ServiceForms::of_process().receive(buffer, static_cast<std::size_t>(size)));
}

}  // namespace

std::string intercept_packets(void* handle) {
  link_map* library = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, &library) != 0 || library == nullptr) return "its place in memory is unknown";
  rtps::ServiceForms::of_process();
  // The order matters: what is rewritten depends on what was received.
  std::string failure = replace_import(*library, "recvmsg", reinterpret_cast<void*>(&receive));
  if (failure.empty()) failure = replace_import(*library, "sendmsg", reinterpret_cast<void*>(&send));
  return failure;
}
#else
std::string intercept_packets(void*) { return "this is done on Linux only"; }
#endif

}  // namespace tfloom::dds
