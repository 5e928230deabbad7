#include "rtps/announcements.hpp"

#include <span>
#include <algorithm>

namespace tfloom::rtps {
namespace {

// The writers of discovery (RTPS 2.5, 9.3.1.5).
constexpr EntityId participants_writer = {0x00, 0x01, 0x00, 0xc2};
constexpr EntityId publications_writer = {0x00, 0x00, 0x03, 0xc2};
constexpr EntityId subscriptions_writer = {0x00, 0x00, 0x04, 0xc2};

// Parameters that hold a locator (9.6.3).
constexpr std::uint16_t unicast_locator_id = 0x002f;
constexpr std::uint16_t default_unicast_locator_id = 0x0031;

// Parameters of one vendor each: the version of Fast DDS, in four bytes, and a text of Cyclone DDS with its version.
constexpr std::uint16_t fast_dds_version_id = 0x8000;
constexpr std::uint16_t cyclone_version_id = 0x8007;
constexpr std::size_t cyclone_text_at = 20;  // after five numbers

constexpr std::uint16_t discovery_unicast_locator_id = 0x0032;

constexpr std::uint16_t topic_name_id = 0x0005;
constexpr std::uint16_t participant_guid_id = 0x0050;
constexpr std::uint16_t endpoint_guid_id = 0x005a;

constexpr std::uint32_t udp_v4 = 1;
constexpr std::uint32_t udp_v6 = 2;
constexpr std::size_t locator_size = 24;

constexpr std::size_t max_versions = 1024;
constexpr std::size_t max_version_size = 32;

// Return the parameters in the payload of a submessage, or nullopt if it has none.
std::optional<Parameters> parameters_of(const Data& data) {
  const Bytes payload = data.payload;
  if (!data.is_sample || data.is_fragment || payload.size() < encapsulation_size) return std::nullopt;
  const bool is_little_endian = payload[1] == std::byte{3};
  if (payload[0] != std::byte{0} || (!is_little_endian && payload[1] != std::byte{2})) return std::nullopt;
  return Parameters(payload.subspan(encapsulation_size), is_little_endian);
}

// Return the text of a string, as a view; empty if it is too short for its length.
std::string_view text_of(const Fields& string) {
  const std::size_t size = string.u32(0);  // includes a zero at its end
  if (size == 0 || !string.has(4 + size)) return {};
  return {reinterpret_cast<const char*>(string.bytes().data()) + 4, size - 1};
}

std::optional<Address> address_of(const Fields& locator) {
  if (!locator.has(locator_size)) return std::nullopt;
  const std::uint32_t kind = locator.u32(0);
  if (kind != udp_v4 && kind != udp_v6) return std::nullopt;  // shared memory, for instance
  Address address{bytes_at<16>(locator.bytes(), 8), locator.u32(4)};
  if (kind == udp_v4) std::fill_n(address.bytes.begin(), 12, std::uint8_t{0});
  return address;
}

std::string version_of_fast_dds(const Fields& version) {
  if (!version.has(4)) return {};
  std::string text;
  for (const std::uint8_t number : bytes_at<4>(version.bytes(), 0)) {
    if (!text.empty()) text += '.';
    text += std::to_string(number);
  }
  return text;
}

// Return the version in the text `host/version/system/processor`; empty if it is none that can be printed.
std::string version_of_cyclone(const Fields& info) {
  if (!info.has(cyclone_text_at)) return {};
  const std::string_view text = text_of(Fields(info.bytes().subspan(cyclone_text_at), info.is_little_endian()));
  const std::size_t begin = text.find('/');
  if (begin == std::string_view::npos) return {};
  const std::string_view rest = text.substr(begin + 1);
  const std::size_t size = rest.find('/');
  if (size == std::string_view::npos || size > max_version_size) return {};
  const std::string_view version = rest.substr(0, size);
  const auto is_plain = [](char character) {
    return (character >= '0' && character <= '9') || (character >= 'a' && character <= 'z') ||
           (character >= 'A' && character <= 'Z') || character == '.' || character == '-' || character == '+';
  };
  return std::ranges::all_of(version, is_plain) ? std::string(version) : std::string();
}

}  // namespace

void Versions::read(const GuidPrefix& source, const Data& data) {
  if (data.writer != participants_writer) return;
  auto parameters = parameters_of(data);
  while (const auto parameter = parameters ? parameters->next() : std::nullopt) {
    std::string version;
    if (is_of_fast_dds(source) && parameter->id == fast_dds_version_id) version = version_of_fast_dds(parameter->value);
    if (is_of_cyclone(source) && parameter->id == cyclone_version_id) version = version_of_cyclone(parameter->value);
    if (version.empty()) continue;
    if (versions_.size() >= max_versions && !versions_.contains(source)) versions_.clear();
    versions_[source] = version;
  }
}

std::string Versions::of(const GuidPrefix& participant) const {
  const auto version = versions_.find(participant);
  return version == versions_.end() ? std::string() : version->second;
}

void Addresses::read(const GuidPrefix& source, const Data& data) {
  if (data.writer != participants_writer && data.writer != publications_writer && data.writer != subscriptions_writer) {
    return;
  }
  auto parameters = parameters_of(data);
  while (const auto parameter = parameters ? parameters->next() : std::nullopt) {
    const bool is_of_user = parameter->id == unicast_locator_id || parameter->id == default_unicast_locator_id;
    if (traffic_ == Traffic::user ? !is_of_user : parameter->id != discovery_unicast_locator_id) continue;
    if (const auto address = address_of(parameter->value)) add(*address, source);
  }
}

void Addresses::add(const Address& address, const GuidPrefix& participant) {
  // One that loses an address, to another participant or because there are too many, is counted down.
  if (const GuidPrefix* const former = participants_.find(address)) {
    if (*former == participant) {
      participants_.use(address);
      return;
    }
    forget(*former);
  } else if (participants_.is_full()) {
    forget(participants_.take_oldest()->second);
  }
  participants_.use(address) = participant;
  ++address_counts_[participant];
}

void Addresses::forget(const GuidPrefix& participant) {
  const auto address_count = address_counts_.find(participant);
  if (--address_count->second == 0) address_counts_.erase(address_count);
}

void Addresses::erase(const GuidPrefix& participant) {
  if (address_counts_.erase(participant) == 0) return;
  participants_.erase_if([&](const Address&, const GuidPrefix& receiver) { return receiver == participant; });
}

std::optional<GuidPrefix> Addresses::participant_at(const Address& address) const {
  const GuidPrefix* const participant = participants_.find(address);
  if (participant == nullptr) return std::nullopt;
  return *participant;
}

namespace {

constexpr EntityId participant_entity = {0x00, 0x00, 0x01, 0xc1};
constexpr std::size_t max_submessage_size = 0xffff;

void add_bytes(std::vector<std::byte>& out, Bytes bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

void add_number(std::vector<std::byte>& out, std::uint16_t number, bool is_little_endian) {
  const std::byte low{static_cast<std::uint8_t>(number & 0xff)};
  const std::byte high{static_cast<std::uint8_t>(number >> 8)};
  out.push_back(is_little_endian ? low : high);
  out.push_back(is_little_endian ? high : low);
}

void add_number32(std::vector<std::byte>& out, std::uint32_t number, bool is_little_endian) {
  for (int i = 0; i < 4; ++i) {
    const int shift = 8 * (is_little_endian ? i : 3 - i);
    out.push_back(static_cast<std::byte>(number >> shift & 0xff));
  }
}

constexpr std::uint16_t content_filter_id = 0x35;
constexpr std::string_view filter_class = "DDSSQL";

// Append a text as CDR has it, where the parameter's value begins at `start`.
void add_text(std::vector<std::byte>& out, std::size_t start, std::string_view text, bool is_little_endian) {
  while ((out.size() - start) % 4 != 0) out.push_back(std::byte{0});
  add_number32(out, static_cast<std::uint32_t>(text.size() + 1), is_little_endian);
  const auto bytes = std::as_bytes(std::span(text));
  add_bytes(out, bytes);
  out.push_back(std::byte{0});
}

// Return the parameter that announces a filter: the names of the filtered topic and of the topic, the language, the
// expression, and its parameters. Empty if it exceeds the size of a parameter.
std::vector<std::byte> filter_parameter(const ContentFilter& filter, bool is_little_endian) {
  std::vector<std::byte> value;
  add_text(value, 0, filter.topic + "_filtered", is_little_endian);
  add_text(value, 0, filter.topic, is_little_endian);
  add_text(value, 0, filter_class, is_little_endian);
  add_text(value, 0, filter.expression, is_little_endian);
  while (value.size() % 4 != 0) value.push_back(std::byte{0});
  add_number32(value, static_cast<std::uint32_t>(filter.parameters.size()), is_little_endian);
  for (const std::string& parameter : filter.parameters) add_text(value, 0, parameter, is_little_endian);
  while (value.size() % 4 != 0) value.push_back(std::byte{0});
  std::vector<std::byte> out;
  if (value.size() >= max_submessage_size) return out;
  add_number(out, content_filter_id, is_little_endian);
  add_number(out, static_cast<std::uint16_t>(value.size()), is_little_endian);
  add_bytes(out, value);
  return out;
}

// Return the filter of the reader that a submessage announces; nullptr if it has none.
const ContentFilter* filter_of(const Data& data, const ContentFilters& filters) {
  if (filters.empty() || data.writer != subscriptions_writer) return nullptr;
  auto parameters = parameters_of(data);
  while (const auto parameter = parameters ? parameters->next() : std::nullopt) {
    if (parameter->id != endpoint_guid_id || !parameter->value.has(std::tuple_size_v<Gid>)) continue;
    const auto filter = filters.find(bytes_at<std::tuple_size_v<Gid>>(parameter->value.bytes(), 0));
    return filter == filters.end() ? nullptr : &filter->second;
  }
  return nullptr;
}

// Return where the parameters of an endpoint's announcement end, from the start of its payload; nullopt if it is none, or if
// it names its participant.
std::optional<std::size_t> end_of_endpoint(const Data& data) {
  if (data.writer != publications_writer && data.writer != subscriptions_writer) return std::nullopt;
  auto parameters = parameters_of(data);
  if (!parameters) return std::nullopt;
  while (const auto parameter = parameters->next()) {
    if (parameter->id == participant_guid_id) return std::nullopt;
  }
  const std::size_t end = encapsulation_size + parameters->offset();
  const bool is_little_endian = data.payload[1] == std::byte{3};
  if (end + 4 > data.payload.size() || Fields(data.payload, is_little_endian).u16(end) != sentinel_id) return std::nullopt;
  return end;
}

}  // namespace

std::optional<std::vector<std::byte>> with_participants(Bytes datagram, const ContentFilters& filters) {
  auto message = Message::of(datagram);
  if (!message) return std::nullopt;
  const Gid participant = gid_of(message->source(), participant_entity);
  const Bytes guid(reinterpret_cast<const std::byte*>(participant.data()), participant.size());
  bool is_changed = false;
  std::vector<std::byte> out(message->header().begin(), message->header().end());
  while (const auto submessage = message->next()) {
    if (submessage->kind == Kind::info_src) return std::nullopt;  // what follows is of another participant
    const auto data = Data::of(*submessage);
    const auto end = data ? end_of_endpoint(*data) : std::nullopt;
    std::size_t size = submessage->bytes.size() - submessage_header_size + 4 + guid.size();
    if (!end || size > max_submessage_size) {
      add_bytes(out, submessage->bytes);
      continue;
    }
    const std::size_t start = out.size();
    const std::size_t at = submessage->bytes.size() - data->payload.size() + *end;
    add_bytes(out, submessage->bytes.first(at));
    const bool is_little_endian = data->payload[1] == std::byte{3};
    add_number(out, participant_guid_id, is_little_endian);
    add_number(out, static_cast<std::uint16_t>(guid.size()), is_little_endian);
    add_bytes(out, guid);
    if (const ContentFilter* const filter = filter_of(*data, filters)) {
      const std::vector<std::byte> added = filter_parameter(*filter, is_little_endian);
      if (size + added.size() <= max_submessage_size) {  // else the reader alone filters
        add_bytes(out, added);
        size += added.size();
      }
    }
    add_bytes(out, submessage->bytes.subspan(at));
    std::vector<std::byte> length;
    add_number(length, static_cast<std::uint16_t>(size), submessage->fields().is_little_endian());
    std::ranges::copy(length, out.begin() + static_cast<std::ptrdiff_t>(start + 2));
    is_changed = true;
  }
  if (!is_changed) return std::nullopt;
  return out;
}

bool is_of_service(std::string_view topic) { return topic.starts_with("rq/") || topic.starts_with("rr/"); }

std::optional<Gid> announced_service_writer(const Data& data) {
  if (data.writer != publications_writer) return std::nullopt;
  std::optional<Gid> writer;
  bool has_service_topic = false;
  auto parameters = parameters_of(data);
  while (const auto parameter = parameters ? parameters->next() : std::nullopt) {
    if (parameter->id == topic_name_id) {
      has_service_topic = is_of_service(text_of(parameter->value));
    } else if (parameter->id == endpoint_guid_id && parameter->value.has(std::tuple_size_v<Gid>)) {
      writer = bytes_at<std::tuple_size_v<Gid>>(parameter->value.bytes(), 0);
    }
  }
  return has_service_topic ? writer : std::nullopt;
}

}  // namespace tfloom::rtps
