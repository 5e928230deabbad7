// What participants announce of themselves: at which addresses they receive, the version of their DDS, and which writers
// belong to services.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rtps/message.hpp"
#include "rtps/recent_map.hpp"

namespace tfloom::rtps {

// An address of UDP: an IPv4 one is in the last four bytes, after zeros.
struct Address {
  std::array<std::uint8_t, 16> bytes{};
  std::uint32_t port = 0;

  // Not <=> by default, because std::array has it from libc++ 17 on.
  bool operator==(const Address&) const = default;
  bool operator<(const Address& other) const {
    return bytes != other.bytes ? bytes < other.bytes : port < other.port;
  }
};

// How many addresses are remembered, because anybody may announce some.
constexpr std::size_t max_addresses = 16'384;

class Addresses {
 public:
  // Where participants receive data of their own endpoints, or what the built-in writers of others send.
  enum class Traffic { user, discovery };

  explicit Addresses(Traffic traffic = Traffic::user) : traffic_(traffic) {}

  // Read what `source` announces of itself in a submessage to the built-in readers; ignore all others.
  void read(const GuidPrefix& source, const Data& data);

  // Forget the addresses of a participant that has left.
  void erase(const GuidPrefix& participant);

  // Return the participant that receives at an address, or nullopt if none has announced it.
  [[nodiscard]] std::optional<GuidPrefix> participant_at(const Address& address) const;

  // Return whether an address of the participant is known.
  [[nodiscard]] bool knows(const GuidPrefix& participant) const { return address_counts_.contains(participant); }

 private:
  void add(const Address& address, const GuidPrefix& participant);
  void forget(const GuidPrefix& participant);  // one of its addresses

  Traffic traffic_;
  RecentMap<Address, GuidPrefix> participants_{max_addresses};
  std::map<GuidPrefix, int> address_counts_;  // how many addresses each has
};

// The versions of DDS that participants announce, each in a parameter of its vendor.
class Versions {
 public:
  // Read what `source` announces in a submessage to the built-in readers; ignore all others.
  void read(const GuidPrefix& source, const Data& data);

  // Forget the version of a participant that has left.
  void erase(const GuidPrefix& participant) { versions_.erase(participant); }

  // Return the version of a participant, as 11.0.1; empty if it has not announced one.
  [[nodiscard]] std::string of(const GuidPrefix& participant) const;

 private:
  std::map<GuidPrefix, std::string> versions_;
};

// Return whether a topic, by its name on the wire, carries the requests or responses of a service.
bool is_of_service(std::string_view topic);

// Which samples of a topic a reader wants, in DDS's subset of SQL.
struct ContentFilter {
  std::string topic;  // its name on the wire
  std::string expression;
  std::vector<std::string> parameters;
};
using ContentFilters = std::map<Gid, ContentFilter>;  // by reader

// Return the datagram in which the announcements of this process's endpoints name their participant, and of its readers
// their content filter; nullopt if it has none that do not. Fast DDS 3 takes an endpoint's participant, and so its node, from
// that parameter alone; libddsc sends it for participants only. Others derive it from the endpoint's GUID, and ignore the
// parameter or check that it agrees. The writers of Fast DDS send a reader only what its filter accepts.
std::optional<std::vector<std::byte>> with_participants(Bytes datagram, const ContentFilters& filters = {});

// Return the writer of a service's requests or responses that a submessage announces, or nullopt if it announces none.
std::optional<Gid> announced_service_writer(const Data& data);

}  // namespace tfloom::rtps
