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

// The functions of libddsc that tfloom calls, each as X(prefix, result, name, parameters): its name there is the prefix and
// the name, and it is a member `name` of Library.
#define TFLOOM_DDS_FUNCTIONS(X) \
  X(dds_, Entity, create_domain, (std::uint32_t domain_id, const char* config)) \
  X(dds_, Entity, create_participant, (std::uint32_t domain_id, const Qos_*, const Listener_*)) \
  X(dds_, Entity, create_publisher, (Entity participant, const Qos_*, const Listener_*)) \
  X(dds_, Entity, create_subscriber, (Entity participant, const Qos_*, const Listener_*)) \
  X(dds_, Entity, create_topic, (Entity participant, const TopicDescriptor*, const char* name, const Qos_*, \
    const Listener_*)) \
  X(dds_, Entity, create_writer, (Entity publisher, Entity topic, const Qos_*, const Listener_*)) \
  X(dds_, Entity, create_reader, (Entity subscriber, Entity topic, const Qos_*, const Listener_*)) \
  X(dds_, Result, get_guid, (Entity, Guid*)) \
  X(dds_, Result, set_listener, (Entity, const Listener_*)) \
  X(dds_, const char*, strretcode, (Result)) \
  X(dds_, void, free, (void*)) \
  X(dds_, Result, write, (Entity writer, const void* sample)) \
  X(dds_, Result, writecdr, (Entity writer, Serdata_*)) \
  X(dds_, Result, unregister_instance, (Entity writer, const void* sample)) \
  X(dds_, Result, readcdr, (Entity reader, Serdata_**, std::uint32_t count, SampleState*, std::uint32_t mask)) \
  X(dds_, Result, takecdr, (Entity reader, Serdata_**, std::uint32_t count, SampleState*, std::uint32_t mask)) \
  X(dds_, Result, take, (Entity reader, void** samples, SampleState*, std::size_t size, std::uint32_t count)) \
  X(dds_, Result, return_loan, (Entity reader, void** samples, Result count)) \
  X(ddsi_, Serdata_*, serdata_from_ser_iov, (const Sertype_*, int kind, IoCount, const IoVec*, std::size_t size)) \
  X(ddsi_, std::uint32_t, serdata_size, (const Serdata_*)) \
  X(ddsi_, Serdata_*, serdata_to_ser_ref, (const Serdata_*, std::size_t offset, std::size_t size, IoVec*)) \
  X(ddsi_, void, serdata_to_ser_unref, (Serdata_*, const IoVec*)) \
  X(ddsi_, void, serdata_unref, (Serdata_*)) \
  X(dds_, Result, get_matched_publications, (Entity reader, InstanceHandle*, std::size_t count)) \
  X(dds_, Result, get_matched_subscriptions, (Entity writer, InstanceHandle*, std::size_t count)) \
  X(dds_, DiscoveredEndpoint*, get_matched_publication_data, (Entity reader, InstanceHandle)) \
  X(dds_, DiscoveredEndpoint*, get_matched_subscription_data, (Entity writer, InstanceHandle)) \
  X(dds_, void, builtintopic_free_endpoint, (DiscoveredEndpoint*)) \
  X(dds_, Listener_*, create_listener, (void* argument)) \
  X(dds_, void, delete_listener, (Listener_*)) \
  X(dds_, Result, lset_data_available_arg, (Listener_*, void (*)(Entity, void*), void* argument, \
    bool reset_on_invoke)) \
  X(dds_, Result, lset_publication_matched_arg, (Listener_*, void (*)(Entity, MatchedStatus, void*), void*, bool)) \
  X(dds_, Result, lset_subscription_matched_arg, (Listener_*, void (*)(Entity, MatchedStatus, void*), void*, bool)) \
  X(dds_, Result, lset_offered_incompatible_qos_arg, (Listener_*, void (*)(Entity, IncompatibleStatus, void*), \
    void*, bool)) \
  X(dds_, Result, lset_requested_incompatible_qos_arg, (Listener_*, void (*)(Entity, IncompatibleStatus, void*), \
    void*, bool)) \
  X(dds_, Result, lset_offered_deadline_missed_arg, (Listener_*, void (*)(Entity, DeadlineStatus, void*), void*, \
    bool)) \
  X(dds_, Result, lset_requested_deadline_missed_arg, (Listener_*, void (*)(Entity, DeadlineStatus, void*), void*, \
    bool)) \
  X(dds_, Result, lset_liveliness_lost_arg, (Listener_*, void (*)(Entity, LostStatus, void*), void*, bool)) \
  X(dds_, Result, lset_liveliness_changed_arg, (Listener_*, void (*)(Entity, LivelinessStatus, void*), void*, bool)) \
  X(dds_, Result, lset_sample_lost_arg, (Listener_*, void (*)(Entity, LostStatus, void*), void*, bool)) \
  X(dds_, Result, get_publication_matched_status, (Entity writer, MatchedStatus*)) \
  X(dds_, Result, get_subscription_matched_status, (Entity reader, MatchedStatus*)) \
  X(dds_, Result, get_offered_incompatible_qos_status, (Entity writer, IncompatibleStatus*)) \
  X(dds_, Result, get_requested_incompatible_qos_status, (Entity reader, IncompatibleStatus*)) \
  X(dds_, Result, get_offered_deadline_missed_status, (Entity writer, DeadlineStatus*)) \
  X(dds_, Result, get_requested_deadline_missed_status, (Entity reader, DeadlineStatus*)) \
  X(dds_, Result, get_liveliness_lost_status, (Entity writer, LostStatus*)) \
  X(dds_, Result, get_liveliness_changed_status, (Entity reader, LivelinessStatus*)) \
  X(dds_, Result, get_sample_lost_status, (Entity reader, LostStatus*)) \
  X(dds_, Result, assert_liveliness, (Entity writer)) \
  X(dds_, Result, wait_for_acks, (Entity writer, std::int64_t timeout_ns)) \
  X(dds_, Result, set_qos, (Entity, const Qos_*)) \
  X(dds_, Qos_*, create_qos, ()) \
  X(dds_, void, delete_qos, (Qos_*)) \
  X(dds_, void, qset_userdata, (Qos_*, const void*, std::size_t size)) \
  X(dds_, void, qset_reliability, (Qos_*, int kind, std::int64_t max_blocking_ns)) \
  X(dds_, void, qset_durability, (Qos_*, int kind)) \
  X(dds_, void, qset_durability_service, (Qos_*, std::int64_t cleanup_ns, int history, std::int32_t depth, \
    std::int32_t max_samples, std::int32_t max_instances, std::int32_t max_samples_per_instance)) \
  X(dds_, void, qset_history, (Qos_*, int kind, std::int32_t depth)) \
  X(dds_, void, qset_deadline, (Qos_*, std::int64_t)) \
  X(dds_, void, qset_lifespan, (Qos_*, std::int64_t)) \
  X(dds_, void, qset_liveliness, (Qos_*, int kind, std::int64_t lease_ns)) \
  X(dds_, void, qset_data_representation, (Qos_*, std::uint32_t count, const std::int16_t*)) \
  X(dds_, void, qset_writer_data_lifecycle, (Qos_*, bool autodispose)) \
  X(dds_, bool, qget_userdata, (const Qos_*, void**, std::size_t*)) \
  X(dds_, bool, qget_reliability, (const Qos_*, int*, std::int64_t*)) \
  X(dds_, bool, qget_durability, (const Qos_*, int*)) \
  X(dds_, bool, qget_history, (const Qos_*, int*, std::int32_t*)) \
  X(dds_, bool, qget_deadline, (const Qos_*, std::int64_t*)) \
  X(dds_, bool, qget_lifespan, (const Qos_*, std::int64_t*)) \
  X(dds_, bool, qget_liveliness, (const Qos_*, int*, std::int64_t*))

struct Library {
  std::string version;  // the library's own, `11.0.1`; empty if it records none
  void* handle = nullptr;  // of dlopen, for the import table
  std::size_t topic_type_offset = 0;  // see `measure_type_offset`; unused where there is `get_entity_sertype`

#define TFLOOM_DECLARE(prefix, result, name, parameters) result(*name) parameters;
  TFLOOM_DDS_FUNCTIONS(TFLOOM_DECLARE)
#undef TFLOOM_DECLARE
  Result (*delete_entity)(Entity);                         // `dds_delete`
  Result (*get_entity_sertype)(Entity, const Sertype_**);  // nullptr in 0.10, where `type_of` needs the next two
  Result (*entity_pin)(Entity, void** memory);
  void (*entity_unpin)(void* memory);

  // Open the library at `path`, once for each path; it stays open until the process ends. It passes a self-test first,
  // unless it is one of the builds of PyPI (`is_common_build`) in one of the versions that were tried (library.cpp).
  // Throw Error if it cannot be opened, is neither version 0.10 nor 11, or fails the self-test.
  static const Library& open(const std::string& path, bool is_common_build = false);

  // Return `result`, or throw Error "<what>: <the library's text>" if it is an error.
  Result check(Result result, const std::string& what) const;
};

}  // namespace tfloom::dds
