#include "dds/loopback.hpp"

#if defined(__linux__) || defined(__APPLE__)
#include <arpa/inet.h>
#include <dirent.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#endif

namespace tfloom::dds {

#if defined(__linux__) || defined(__APPLE__)
namespace {

#ifdef __linux__
constexpr const char* descriptors_folder = "/proc/self/fd";
#else
constexpr const char* descriptors_folder = "/dev/fd";
#endif

// RTPS 2.5, 9.6.2.3: the unicast ports of a participant index are first_port + 2 * index, for discovery, and the next one,
// for data. They end where those of the next domain begin.
constexpr std::uint32_t domain_gain = 250;
constexpr std::uint32_t first_unicast_offset = 10;
constexpr std::uint32_t base_port = 7400 + first_unicast_offset;
constexpr std::uint32_t unicast_ports = domain_gain - first_unicast_offset;

std::optional<std::string> loopback_interface() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return std::nullopt;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(first, freeifaddrs);
  for (const ifaddrs* candidate = first; candidate != nullptr; candidate = candidate->ifa_next) {
    if (candidate->ifa_addr == nullptr || candidate->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in address{};
    std::memcpy(&address, candidate->ifa_addr, sizeof(address));
    if (ntohl(address.sin_addr.s_addr) == INADDR_LOOPBACK) return candidate->ifa_name;
  }
  return std::nullopt;
}

// Return the port if `descriptor` is a UDP socket that is bound to all addresses, or nullopt.
std::optional<std::uint32_t> listening_port(int descriptor) {
  int type = 0;
  socklen_t size = sizeof(type);
  if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM) return std::nullopt;
  sockaddr_storage bound{};
  size = sizeof(bound);
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&bound), &size) != 0) return std::nullopt;
  if (bound.ss_family != AF_INET) return std::nullopt;
  sockaddr_in address{};
  std::memcpy(&address, &bound, sizeof(address));
  if (address.sin_addr.s_addr != htonl(INADDR_ANY)) return std::nullopt;
  return ntohs(address.sin_port);
}

using SocketsByOffset = std::map<std::uint32_t, int>;  // from a domain's unicast port, less the first, to its descriptor

// A descriptor that another thread closes or opens meanwhile is not a candidate: a port belongs to one socket, and the
// library holds those of the domain.
std::optional<SocketsByOffset> find_sockets(std::uint32_t domain_id) {
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir(descriptors_folder), closedir);
  if (folder == nullptr) return std::nullopt;
  const std::uint32_t first_port = base_port + domain_gain * domain_id;
  SocketsByOffset sockets;
  while (const dirent* entry = readdir(folder.get())) {
    char* end = nullptr;
    const long descriptor = std::strtol(entry->d_name, &end, 10);
    if (end == entry->d_name || *end != '\0') continue;  // . and ..
    const auto port = listening_port(static_cast<int>(descriptor));
    if (!port || *port < first_port || *port >= first_port + unicast_ports) continue;
    sockets[*port - first_port] = static_cast<int>(descriptor);
  }
  return sockets;
}

bool bind_to_interface(int descriptor, const std::string& name) {
#ifdef __linux__
  return setsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, name.c_str(), static_cast<socklen_t>(name.size() + 1)) == 0;
#else
  const unsigned index = if_nametoindex(name.c_str());
  return setsockopt(descriptor, IPPROTO_IP, IP_BOUND_IF, &index, sizeof(index)) == 0;
#endif
}

}  // namespace

std::string bind_to_loopback(std::uint32_t domain_id) {
  const auto interface = loopback_interface();
  if (!interface) return "no network interface has the address 127.0.0.1";
  const auto sockets = find_sockets(domain_id);
  if (!sockets) return std::string(descriptors_folder) + " can't be read: " + std::strerror(errno);
  bool is_found = false;
  for (const auto& [offset, discovery] : *sockets) {
    const auto data = sockets->find(offset + 1);
    if (offset % 2 != 0 || data == sockets->end()) continue;  // of a pair, because each port alone may be another's
    for (const int descriptor : {discovery, data->second}) {
      if (!bind_to_interface(descriptor, *interface)) {
        return "the kernel refused to bind them to " + *interface + ": " + std::strerror(errno);
      }
    }
    is_found = true;
  }
  return is_found ? "" : "they are not among this process's descriptors";
}

#else

std::string bind_to_loopback(std::uint32_t) { return "this system can't bind a socket to an interface"; }

#endif

}  // namespace tfloom::dds
