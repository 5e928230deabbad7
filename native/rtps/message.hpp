// A view of the RTPS messages in a datagram (RTPS 2.5, 8.3 and 9.4). Their bytes are untrusted: each read is checked
// against the bytes that are left.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include "core/sink.hpp"

namespace tfloom::rtps {

using Bytes = std::span<const std::byte>;
using GuidPrefix = std::array<std::uint8_t, 12>;
using EntityId = std::array<std::uint8_t, 4>;

constexpr std::size_t message_header_size = 20;
constexpr std::size_t submessage_header_size = 4;
constexpr std::size_t encapsulation_size = 4;

enum class Kind : std::uint8_t {
  pad = 0x01,
  acknack = 0x06,
  heartbeat = 0x07,
  gap = 0x08,
  info_ts = 0x09,
  info_src = 0x0c,
  info_dst = 0x0e,
  data = 0x15,
  data_frag = 0x16,
};

constexpr unsigned little_endian_flag = 0x01;
constexpr unsigned inline_qos_flag = 0x02;  // of data and data_frag
constexpr unsigned final_flag = 0x02;       // of heartbeat: no acknowledgement is requested
constexpr unsigned invalidate_flag = 0x02;  // of info_ts: there is no time
constexpr unsigned data_flag = 0x04;        // of data: the payload is a sample, not a key

constexpr std::uint16_t sentinel_id = 1;  // the last parameter of a list

template <std::size_t size>
std::array<std::uint8_t, size> bytes_at(Bytes bytes, std::size_t at) {
  std::array<std::uint8_t, size> result{};
  if (at + size <= bytes.size()) std::memcpy(result.data(), bytes.data() + at, size);
  return result;
}

inline Gid gid_of(const GuidPrefix& prefix, const EntityId& entity) {
  Gid gid{};
  std::memcpy(gid.data(), prefix.data(), prefix.size());
  std::memcpy(gid.data() + prefix.size(), entity.data(), entity.size());
  return gid;
}

inline GuidPrefix prefix_of(const Gid& gid) {
  GuidPrefix prefix{};
  std::memcpy(prefix.data(), gid.data(), prefix.size());
  return prefix;
}

// Return whether a participant runs on Fast DDS, by its vendor id: the first bytes of its prefix (9.3.1.5).
inline bool is_of_fast_dds(const GuidPrefix& participant) { return participant[0] == 0x01 && participant[1] == 0x0f; }

inline bool is_of_cyclone(const GuidPrefix& participant) { return participant[0] == 0x01 && participant[1] == 0x10; }

// Numbers in the byte order that a submessage, or a list of parameters, declares.
class Fields {
 public:
  Fields(Bytes bytes, bool is_little_endian) : bytes_(bytes), is_little_endian_(is_little_endian) {}

  [[nodiscard]] Bytes bytes() const { return bytes_; }
  [[nodiscard]] bool is_little_endian() const { return is_little_endian_; }
  [[nodiscard]] bool has(std::size_t size) const { return bytes_.size() >= size; }

  // Return the number at an offset; 0 beyond the end.
  [[nodiscard]] std::uint16_t u16(std::size_t at) const { return static_cast<std::uint16_t>(number(at, 2)); }
  [[nodiscard]] std::uint32_t u32(std::size_t at) const { return static_cast<std::uint32_t>(number(at, 4)); }
  // A sequence number: its high half, then its low half.
  [[nodiscard]] std::uint64_t sequence_number(std::size_t at) const {
    return number(at, 4) << 32 | number(at + 4, 4);
  }

 private:
  [[nodiscard]] std::uint64_t number(std::size_t at, std::size_t size) const {
    if (at + size > bytes_.size()) return 0;
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = is_little_endian_ ? size - 1 - i : i;
      result = result << 8 | std::to_integer<std::uint64_t>(bytes_[at + place]);
    }
    return result;
  }

  Bytes bytes_;
  bool is_little_endian_;
};

struct Submessage {
  Kind kind{};
  unsigned flags = 0;
  Bytes bytes;  // includes its header

  [[nodiscard]] Fields fields() const { return {bytes, (flags & little_endian_flag) != 0}; }
};

// The submessages of a datagram, in turn.
class Message {
 public:
  // Return the view of a datagram, or nullopt if it is not an RTPS message.
  static std::optional<Message> of(Bytes datagram) {
    if (datagram.size() < message_header_size || std::memcmp(datagram.data(), "RTPS", 4) != 0) return std::nullopt;
    return Message(datagram);
  }

  [[nodiscard]] Bytes header() const { return datagram_.first(message_header_size); }
  [[nodiscard]] GuidPrefix source() const { return bytes_at<12>(datagram_, 8); }

  // Return the next submessage; nullopt at the end, or if the rest is not a submessage.
  std::optional<Submessage> next() {
    const Bytes left = datagram_.subspan(at_);
    if (left.size() < submessage_header_size) return std::nullopt;
    Submessage submessage{static_cast<Kind>(left[0]), std::to_integer<unsigned>(left[1]), {}};
    std::size_t size = Fields(left, (submessage.flags & little_endian_flag) != 0).u16(2);
    // A length of 0 extends to the end of the message, unless the submessage may be empty.
    const bool may_be_empty = submessage.kind == Kind::pad || submessage.kind == Kind::info_ts;
    if (size == 0 && !may_be_empty) size = left.size() - submessage_header_size;
    if (size > left.size() - submessage_header_size) return std::nullopt;
    submessage.bytes = left.first(submessage_header_size + size);
    at_ += submessage.bytes.size();
    return submessage;
  }

 private:
  explicit Message(Bytes datagram) : datagram_(datagram) {}

  Bytes datagram_;
  std::size_t at_ = message_header_size;
};

// The parameters of a list (9.4.2.11), in turn.
class Parameters {
 public:
  struct Parameter {
    std::uint16_t id = 0;
    Fields value;
  };

  Parameters(Bytes bytes, bool is_little_endian) : fields_(bytes, is_little_endian) {}

  // Return the next parameter; nullopt at the sentinel, or if the rest is not a parameter.
  std::optional<Parameter> next() {
    const Bytes bytes = fields_.bytes();
    if (bytes.size() - at_ < 4) return std::nullopt;
    const std::uint16_t id = fields_.u16(at_);
    const std::size_t size = fields_.u16(at_ + 2);
    if (id == sentinel_id || size > bytes.size() - at_ - 4) return std::nullopt;
    const Parameter parameter{id, Fields(bytes.subspan(at_ + 4, size), fields_.is_little_endian())};
    at_ += 4 + size;
    return parameter;
  }

  [[nodiscard]] std::size_t offset() const { return at_; }  // of the next parameter, or of the sentinel

 private:
  Fields fields_;
  std::size_t at_ = 0;
};

// A data or data_frag submessage.
struct Data {
  EntityId writer{};
  std::uint64_t sequence_number = 0;
  bool is_fragment = false;
  std::uint32_t first_fragment = 0;  // counted from 1
  std::uint16_t fragment_count = 0;
  std::uint16_t fragment_size = 0;
  std::uint32_t sample_size = 0;
  bool is_little_endian = true;
  bool is_sample = false;      // and not the key of an instance
  std::size_t inline_qos_at = 0;  // the end of the fixed fields
  Bytes inline_qos;           // includes its sentinel; empty if there is none
  Bytes payload;

  // Return the view of a submessage, or nullopt if it is of another kind, or too short.
  static std::optional<Data> of(const Submessage& submessage) {
    const bool is_fragment = submessage.kind == Kind::data_frag;
    if (!is_fragment && submessage.kind != Kind::data) return std::nullopt;
    const std::size_t fixed_size = is_fragment ? 36 : 24;
    const Fields fields = submessage.fields();
    if (!fields.has(fixed_size)) return std::nullopt;
    Data data;
    data.is_little_endian = fields.is_little_endian();
    data.is_fragment = is_fragment;
    data.is_sample = is_fragment ? (submessage.flags & 0x04) == 0 : (submessage.flags & data_flag) != 0;
    data.writer = bytes_at<4>(submessage.bytes, 12);
    data.sequence_number = fields.sequence_number(16);
    if (is_fragment) {
      data.first_fragment = fields.u32(24);
      data.fragment_count = fields.u16(28);
      data.fragment_size = fields.u16(30);
      data.sample_size = fields.u32(32);
    }
    data.inline_qos_at = 8 + std::size_t{fields.u16(6)};
    if (data.inline_qos_at < fixed_size || data.inline_qos_at > submessage.bytes.size()) return std::nullopt;
    const Bytes rest = submessage.bytes.subspan(data.inline_qos_at);
    std::size_t inline_qos_size = 0;
    if ((submessage.flags & inline_qos_flag) != 0) {
      Parameters parameters(rest, data.is_little_endian);
      while (parameters.next()) {
      }
      inline_qos_size = parameters.offset() + 4;
      if (inline_qos_size > rest.size() || Fields(rest, data.is_little_endian).u16(parameters.offset()) != sentinel_id) {
        return std::nullopt;
      }
    }
    data.inline_qos = rest.first(inline_qos_size);
    data.payload = rest.subspan(inline_qos_size);
    return data;
  }
};

}  // namespace tfloom::rtps
