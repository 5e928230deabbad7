// libddsc, the shared library of Cyclone DDS, version 0.10 or 11, opened at run time.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "dds/abi.hpp"

namespace tfloom::dds {

// The library could not be opened, or one of its functions returned an error.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The functions of libddsc that tfloom calls, each under its own name without `dds_` or `ddsi_`.
struct Library {
  std::string version;  // the library's own, `11.0.1`; empty if it records none
  void* handle = nullptr;  // of dlopen, for the import table
  std::size_t topic_type_offset = 0;  // see `measure_type_offset`; unused where there is `get_entity_sertype`

  Entity (*create_domain)(std::uint32_t domain_id, const char* config);
  Entity (*create_participant)(std::uint32_t domain_id, const Qos_*, const Listener_*);
  Entity (*create_publisher)(Entity participant, const Qos_*, const Listener_*);
  Entity (*create_subscriber)(Entity participant, const Qos_*, const Listener_*);
  Entity (*create_topic)(Entity participant, const TopicDescriptor*, const char* name, const Qos_*, const Listener_*);
  Entity (*create_writer)(Entity publisher, Entity topic, const Qos_*, const Listener_*);
  Entity (*create_reader)(Entity subscriber, Entity topic, const Qos_*, const Listener_*);
  Result (*delete_entity)(Entity);
  Result (*get_guid)(Entity, Guid*);
  Result (*get_entity_sertype)(Entity, const Sertype_**);  // nullptr in 0.10, where `type_of` needs the next two
  Result (*entity_pin)(Entity, void** memory);
  void (*entity_unpin)(void* memory);
  Result (*set_listener)(Entity, const Listener_*);
  const char* (*strretcode)(Result);
  void (*free)(void*);

  Result (*write)(Entity writer, const void* sample);
  Result (*writecdr)(Entity writer, Serdata_*);
  Result (*unregister_instance)(Entity writer, const void* sample);
  Result (*readcdr)(Entity reader, Serdata_**, std::uint32_t count, SampleState*, std::uint32_t mask);
  Result (*takecdr)(Entity reader, Serdata_**, std::uint32_t count, SampleState*, std::uint32_t mask);
  Result (*take)(Entity reader, void** samples, SampleState*, std::size_t size, std::uint32_t count);
  Result (*return_loan)(Entity reader, void** samples, Result count);
  Serdata_* (*serdata_from_ser_iov)(const Sertype_*, int kind, IoCount, const IoVec*, std::size_t size);
  std::uint32_t (*serdata_size)(const Serdata_*);
  Serdata_* (*serdata_to_ser_ref)(const Serdata_*, std::size_t offset, std::size_t size, IoVec*);
  void (*serdata_to_ser_unref)(Serdata_*, const IoVec*);
  void (*serdata_unref)(Serdata_*);

  Result (*get_matched_publications)(Entity reader, InstanceHandle*, std::size_t count);
  Result (*get_matched_subscriptions)(Entity writer, InstanceHandle*, std::size_t count);
  DiscoveredEndpoint* (*get_matched_publication_data)(Entity reader, InstanceHandle);
  DiscoveredEndpoint* (*get_matched_subscription_data)(Entity writer, InstanceHandle);
  void (*builtintopic_free_endpoint)(DiscoveredEndpoint*);

  Listener_* (*create_listener)(void* argument);
  void (*delete_listener)(Listener_*);
  Result (*lset_data_available_arg)(Listener_*, void (*)(Entity, void*), void* argument, bool reset_on_invoke);

  Result (*lset_publication_matched_arg)(Listener_*, void (*)(Entity, MatchedStatus, void*), void*, bool);
  Result (*lset_subscription_matched_arg)(Listener_*, void (*)(Entity, MatchedStatus, void*), void*, bool);
  Result (*lset_offered_incompatible_qos_arg)(Listener_*, void (*)(Entity, IncompatibleStatus, void*), void*, bool);
  Result (*lset_requested_incompatible_qos_arg)(Listener_*, void (*)(Entity, IncompatibleStatus, void*), void*, bool);
  Result (*lset_offered_deadline_missed_arg)(Listener_*, void (*)(Entity, DeadlineStatus, void*), void*, bool);
  Result (*lset_requested_deadline_missed_arg)(Listener_*, void (*)(Entity, DeadlineStatus, void*), void*, bool);
  Result (*lset_liveliness_lost_arg)(Listener_*, void (*)(Entity, LostStatus, void*), void*, bool);
  Result (*lset_liveliness_changed_arg)(Listener_*, void (*)(Entity, LivelinessStatus, void*), void*, bool);
  Result (*lset_sample_lost_arg)(Listener_*, void (*)(Entity, LostStatus, void*), void*, bool);
  Result (*get_publication_matched_status)(Entity writer, MatchedStatus*);
  Result (*get_subscription_matched_status)(Entity reader, MatchedStatus*);
  Result (*get_offered_incompatible_qos_status)(Entity writer, IncompatibleStatus*);
  Result (*get_requested_incompatible_qos_status)(Entity reader, IncompatibleStatus*);
  Result (*get_offered_deadline_missed_status)(Entity writer, DeadlineStatus*);
  Result (*get_requested_deadline_missed_status)(Entity reader, DeadlineStatus*);
  Result (*get_liveliness_lost_status)(Entity writer, LostStatus*);
  Result (*get_liveliness_changed_status)(Entity reader, LivelinessStatus*);
  Result (*get_sample_lost_status)(Entity reader, LostStatus*);
  Result (*assert_liveliness)(Entity writer);
  Result (*wait_for_acks)(Entity writer, std::int64_t timeout_ns);

  Qos_* (*create_qos)();
  void (*delete_qos)(Qos_*);
  void (*qset_userdata)(Qos_*, const void*, std::size_t size);
  void (*qset_reliability)(Qos_*, int kind, std::int64_t max_blocking_ns);
  void (*qset_durability)(Qos_*, int kind);
  void (*qset_durability_service)(Qos_*, std::int64_t cleanup_ns, int history, std::int32_t depth,
                                  std::int32_t max_samples, std::int32_t max_instances,
                                  std::int32_t max_samples_per_instance);
  void (*qset_history)(Qos_*, int kind, std::int32_t depth);
  void (*qset_deadline)(Qos_*, std::int64_t);
  void (*qset_lifespan)(Qos_*, std::int64_t);
  void (*qset_liveliness)(Qos_*, int kind, std::int64_t lease_ns);
  void (*qset_data_representation)(Qos_*, std::uint32_t count, const std::int16_t*);
  void (*qset_writer_data_lifecycle)(Qos_*, bool autodispose);
  bool (*qget_userdata)(const Qos_*, void**, std::size_t*);
  bool (*qget_reliability)(const Qos_*, int*, std::int64_t*);
  bool (*qget_durability)(const Qos_*, int*);
  bool (*qget_history)(const Qos_*, int*, std::int32_t*);
  bool (*qget_deadline)(const Qos_*, std::int64_t*);
  bool (*qget_lifespan)(const Qos_*, std::int64_t*);
  bool (*qget_liveliness)(const Qos_*, int*, std::int64_t*);

  // Open the library at `path`, once for each path; it stays open until the process ends. It passes a self-test first,
  // unless it is one of the builds of PyPI (`is_common_build`) in one of the versions that were tried (library.cpp).
  // Throw Error if it cannot be opened, is neither version 0.10 nor 11, or fails the self-test.
  static const Library& open(const std::string& path, bool is_common_build = false);

  // Return `result`, or throw Error "<what>: <the library's text>" if it is an error.
  Result check(Result result, const std::string& what) const;
};

}  // namespace tfloom::dds
