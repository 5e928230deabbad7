// The types of libddsc's C interface (version 11) that are passed by value or read in place. All others are opaque.
#pragma once

#include <cstddef>
#include <cstdint>
#ifndef _WIN32
#include <sys/uio.h>
#endif

namespace tfloom::dds {

using Entity = std::int32_t;  // a handle; negative: an error
using Result = std::int32_t;  // 0 or a count; negative: an error
using InstanceHandle = std::uint64_t;

struct Qos_;
struct Listener_;
struct Sertype_;
struct Serdata_;

constexpr Result precondition_not_met = -4;
constexpr Result timeout = -10;

// Handles of the topics that describe what has been discovered.
constexpr Entity discovered_participants = 0x7fff0001;
constexpr Entity discovered_publications = 0x7fff0003;
constexpr Entity discovered_subscriptions = 0x7fff0004;

constexpr std::uint32_t alive_instance = 16;

#ifdef _WIN32
struct IoVec {
  unsigned long iov_len;
  void* iov_base;
};
using IoCount = unsigned long;
#else
using IoVec = iovec;
#ifdef __linux__
using IoCount = std::size_t;
#else
using IoCount = int;
#endif
#endif

struct Guid {
  std::uint8_t bytes[16];
};

struct SampleState {
  std::uint32_t sample_state;
  std::uint32_t view_state;
  std::uint32_t instance_state;
  bool valid_data;
  std::int64_t source_stamp_ns;
  InstanceHandle instance;
  InstanceHandle publication;
  std::uint32_t disposed_generation_count;
  std::uint32_t no_writers_generation_count;
  std::uint32_t sample_rank;
  std::uint32_t generation_rank;
  std::uint32_t absolute_generation_rank;
};

struct DeadlineStatus {
  std::uint32_t total_count;
  std::int32_t total_count_change;
  InstanceHandle last_instance;
};

struct IncompatibleStatus {
  std::uint32_t total_count;
  std::int32_t total_count_change;
  std::uint32_t last_policy_id;
};

struct MatchedStatus {
  std::uint32_t total_count;
  std::int32_t total_count_change;
  std::uint32_t current_count;
  std::int32_t current_count_change;
  InstanceHandle last_peer;
};

struct LostStatus {  // of liveliness, and of samples
  std::uint32_t total_count;
  std::int32_t total_count_change;
};

struct LivelinessStatus {
  std::uint32_t alive_count;
  std::uint32_t not_alive_count;
  std::int32_t alive_count_change;
  std::int32_t not_alive_count_change;
  InstanceHandle last_publication;
};

struct DiscoveredParticipant {
  Guid key;
  Qos_* qos;
};

struct DiscoveredEndpoint {
  Guid key;
  Guid participant_key;
  InstanceHandle participant_instance;
  char* topic_name;
  char* type_name;
  Qos_* qos;
};

struct SerializedType {
  const void* data;
  std::uint32_t size;
};

struct TopicDescriptor {
  std::uint32_t size;
  std::uint32_t alignment;
  std::uint32_t flags;
  std::uint32_t key_count;
  const char* type_name;
  const void* keys;
  std::uint32_t op_count;
  const std::uint32_t* ops;
  const char* metadata;
  SerializedType type_information;
  SerializedType type_mapping;
  std::uint32_t allowed_representations;
};

}  // namespace tfloom::dds
