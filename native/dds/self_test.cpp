#include "dds/self_test.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "core/wall_clock.hpp"
#include "dds/canaried.hpp"
#include "dds/endpoint.hpp"
#include "dds/entity.hpp"
#include "dds/listener_call.hpp"
#include "dds/memory_probe.hpp"
#include "dds/qos.hpp"
#include "dds/serdata.hpp"
#include "dds/silent_domain.hpp"
#include "dds/topic_type.hpp"

namespace tfloom::dds {
namespace {

constexpr const char* topic_name = "rt/tfloom_self_test";
constexpr const char* type_name = "tfloom::msg::dds_::SelfTest_";
constexpr const char* participant_data = "enclave=/self_test;";
constexpr const char* endpoint_data = "typehash=self_test;";

constexpr std::uint32_t reliability_policy = 11;
constexpr std::uint32_t new_view = 4;
constexpr std::uint32_t unread_sample = 2;
constexpr std::uint32_t read_sample = 1;
constexpr std::size_t sample_count = 2;
constexpr std::size_t sample_size = 8;
constexpr unsigned char header[4] = {0, 1, 0, 0};

// Throw unless `holds`: the library's `type` isn't as abi.hpp declares it, as `function` shows.
void require(bool holds, const std::string& type, const std::string& function) {
  if (!holds) throw Error("its " + type + " differs (" + function + ")");
}

bool is_equal(const Guid& left, const Guid& right) { return std::memcmp(&left, &right, sizeof(Guid)) == 0; }

bool is_user_data(const Library& library, const Qos_* qos, const char* expected) {
  return is_readable(qos, sizeof(void*)) && read_user_data(library, qos) == expected;
}

// A writer and a reader that match, and a writer that doesn't match for its reliability, in a domain without a network.
class SelfTest {
 public:
  explicit SelfTest(const Library& library)
      : l_(library),
        domain_(l_, participant_data),
        publisher_(l_, l_.create_publisher(domain_.participant(), nullptr, nullptr), "its publisher can't be created"),
        subscriber_(l_, l_.create_subscriber(domain_.participant(), nullptr, nullptr), "its subscriber can't be created"),
        topic_(create_topic(l_, domain_.participant(), {topic_name, type_name})),
        writer_(create_writer(Reliability::reliable, make_writer_listener())),
        reader_(create_reader()),
        unmatched_writer_(create_writer(Reliability::best_effort, make_unmatched_listener())) {}

  void run() {
    check_results();
    check_qos();
    check_matches();
    check_calls();
    check_statuses();
    check_samples();
    check_discovered_participant();
    check_discovered_endpoint(discovered_publications, writer_);
    check_discovered_endpoint(discovered_subscriptions, reader_);
  }

 private:
  Qos qos(Reliability reliability) const {
    Qos qos;
    qos.reliability = reliability;
    qos.depth = 7;
    return qos;
  }

  ListenerHandle make_writer_listener() {
    ListenerHandle listener = make_listener(l_);
    l_.lset_publication_matched_arg(listener.get(), &decltype(writer_matched_)::on_call, &writer_matched_, false);
    return listener;
  }

  ListenerHandle make_unmatched_listener() {
    ListenerHandle listener = make_listener(l_);
    l_.lset_offered_incompatible_qos_arg(listener.get(), &decltype(incompatible_)::on_call, &incompatible_, false);
    return listener;
  }

  OwnedEntity create_writer(Reliability reliability, const ListenerHandle& listener) {
    return {l_,
            l_.create_writer(publisher_.get(), topic_.get(),
                             make_writer_qos(l_, qos(reliability), endpoint_data).get(), listener.get()),
            "its writer can't be created"};
  }

  OwnedEntity create_reader() {
    const ListenerHandle listener = make_listener(l_);
    l_.lset_subscription_matched_arg(listener.get(), &decltype(reader_matched_)::on_call, &reader_matched_, false);
    l_.lset_liveliness_changed_arg(listener.get(), &decltype(liveliness_)::on_call, &liveliness_, false);
    return {l_,
            l_.create_reader(subscriber_.get(), topic_.get(),
                             make_reader_qos(l_, qos(Reliability::reliable), endpoint_data).get(), listener.get()),
            "its reader can't be created"};
  }

  Guid guid_of(const OwnedEntity& entity) { return guid_of(entity.get()); }
  Guid participant_guid() { return guid_of(domain_.participant()); }

  Guid guid_of(Entity entity) {
    Canaried<Guid> guid;
    l_.check(l_.get_guid(entity, guid.data()), "its GUIDs can't be got");
    require(guid.is_intact_beyond() && !is_equal(guid[0], Canaried<Guid>()[0]), "GUID", "dds_get_guid");
    return guid[0];
  }

  void check_results() {
    require(l_.create_domain(SilentDomain::id, SilentDomain::configuration) == precondition_not_met, "result code", "dds_create_domain");
    require(is_text(l_.strretcode(timeout), "Timeout"), "result code", "dds_strretcode");
    if (l_.get_entity_sertype != nullptr) {
      Canaried<const Sertype_*> type;
      l_.check(l_.get_entity_sertype(writer_.get(), type.data()), "its types can't be got");
      require(type.is_intact_beyond() && is_readable(type[0], sizeof(void*)), "type", "dds_get_entity_sertype");
    }
    type_ = type_of(l_, topic_.get(), writer_.get());
  }

  // Compare what a getter writes: a kind, and a duration or a depth.
  template <typename Number>
  void check_policy(const Qos_* q, bool (*get)(const Qos_*, int*, Number*), int kind, Number number,
                    const std::string& function) {
    Canaried<int> kinds;
    Canaried<Number> numbers;
    const bool has = get(q, kinds.data(), numbers.data());
    require(has && kinds.is_intact_beyond() && numbers.is_intact_beyond() && kinds[0] == kind && numbers[0] == number,
            "policy", function);
  }

  void check_duration(const Qos_* q, bool (*get)(const Qos_*, std::int64_t*), std::int64_t expected,
                      const std::string& function) {
    Canaried<std::int64_t> duration;
    require(get(q, duration.data()) && duration.is_intact_beyond() && duration[0] == expected, "policy", function);
  }

  void check_qos() {
    Qos qos;
    qos.durability = Durability::transient_local;
    qos.depth = 7;
    qos.deadline_ns = 11'000'000'000;
    qos.lifespan_ns = 12'000'000'000;
    qos.liveliness = Liveliness::manual_by_topic;
    qos.liveliness_lease_ns = 13'000'000'000;
    const QosHandle handle = make_writer_qos(l_, qos, endpoint_data);
    const Qos_* q = handle.get();
    check_policy(q, l_.qget_reliability, 1, infinite_ns, "dds_qget_reliability");
    check_policy<std::int32_t>(q, l_.qget_history, 0, qos.depth, "dds_qget_history");
    check_policy(q, l_.qget_liveliness, 2, qos.liveliness_lease_ns, "dds_qget_liveliness");
    check_duration(q, l_.qget_deadline, qos.deadline_ns, "dds_qget_deadline");
    check_duration(q, l_.qget_lifespan, qos.lifespan_ns, "dds_qget_lifespan");
    Canaried<int> durability;
    require(l_.qget_durability(q, durability.data()) && durability.is_intact_beyond() && durability[0] == 1, "policy",
            "dds_qget_durability");
    Canaried<void*> data;
    Canaried<std::size_t> size;
    require(l_.qget_userdata(q, data.data(), size.data()) && data.is_intact_beyond() && size.is_intact_beyond() &&
                size[0] == std::strlen(endpoint_data) && is_readable(data[0], size[0]),
            "user data", "dds_qget_userdata");
    const std::unique_ptr<void, void (*)(void*)> owner(data[0], l_.free);
    require(std::memcmp(owner.get(), endpoint_data, size[0]) == 0, "user data", "dds_qget_userdata");
  }

  template <typename GetMatched>
  InstanceHandle only_match(GetMatched get, const OwnedEntity& entity, const std::string& function) {
    Canaried<InstanceHandle, 4> handles;
    require(get(entity.get(), handles.data(), 4) == 1 && handles.is_intact_beyond(1) && handles[0] != 0,
            "instance handle", function);
    return handles[0];
  }

  void check_matches() {
    require(writer_matched_.wait(writer_.get()), "matched status", "dds_lset_publication_matched_arg");
    require(reader_matched_.wait(reader_.get()), "matched status", "dds_lset_subscription_matched_arg");
    reader_handle_ = only_match(l_.get_matched_subscriptions, writer_, "dds_get_matched_subscriptions");
    writer_handle_ = only_match(l_.get_matched_publications, reader_, "dds_get_matched_publications");
    check_endpoint(l_.get_matched_subscription_data(writer_.get(), reader_handle_), reader_,
                   "dds_get_matched_subscription_data");
    check_endpoint(l_.get_matched_publication_data(reader_.get(), writer_handle_), writer_,
                   "dds_get_matched_publication_data");
  }

  void check_endpoint(DiscoveredEndpoint* found, const OwnedEntity& expected, const std::string& function) {
    require(is_described(found, expected), "endpoint data", function);
    l_.builtintopic_free_endpoint(found);
  }

  bool is_described(const DiscoveredEndpoint* found, const OwnedEntity& expected) {
    return is_readable(found, sizeof(DiscoveredEndpoint)) && is_equal(found->key, guid_of(expected)) &&
           is_equal(found->participant_key, participant_guid()) && is_text(found->topic_name, topic_name) &&
           is_text(found->type_name, type_name) && is_user_data(l_, found->qos, endpoint_data);
  }

  static bool is_first_match(const MatchedStatus& status, InstanceHandle peer) {
    return status.total_count == 1 && status.total_count_change == 1 && status.current_count == 1 &&
           status.current_count_change == 1 && status.last_peer == peer;
  }

  void check_calls() {
    require(is_first_match(writer_matched_.status, reader_handle_), "matched status",
            "dds_lset_publication_matched_arg");
    require(is_first_match(reader_matched_.status, writer_handle_), "matched status",
            "dds_lset_subscription_matched_arg");
    const LivelinessStatus& liveliness = liveliness_.status;
    require(liveliness_.wait(reader_.get()) && liveliness.alive_count == 1 && liveliness.alive_count_change == 1 &&
                liveliness.not_alive_count == 0 && liveliness.not_alive_count_change == 0 &&
                liveliness.last_publication == writer_handle_,
            "liveliness status", "dds_lset_liveliness_changed_arg");
    const IncompatibleStatus& incompatible = incompatible_.status;
    require(incompatible_.wait(unmatched_writer_.get()) && incompatible.total_count == 1 &&
                incompatible.total_count_change == 1 && incompatible.last_policy_id == reliability_policy,
            "incompatible QoS status", "dds_lset_offered_incompatible_qos_arg");
  }

  template <typename Status>
  Status status(Result (*get)(Entity, Status*), const OwnedEntity& entity, const std::string& type,
                const std::string& function) {
    Canaried<Status> status;
    l_.check(get(entity.get(), status.data()), "its statuses can't be got");
    require(status.is_intact_beyond(), type, function);
    return status[0];
  }

  void check_matched_status(Result (*get)(Entity, MatchedStatus*), const OwnedEntity& entity, InstanceHandle peer,
                            const std::string& function) {
    const auto found = status(get, entity, "matched status", function);
    require(found.total_count == 1 && found.current_count == 1 && found.last_peer == peer, "matched status", function);
  }

  void check_incompatible_status(Result (*get)(Entity, IncompatibleStatus*), const OwnedEntity& entity,
                                 const std::string& function) {
    const auto found = status(get, entity, "incompatible QoS status", function);
    require(found.total_count == 1 && found.last_policy_id == reliability_policy, "incompatible QoS status", function);
  }

  template <typename Status>
  void check_unchanged_status(Result (*get)(Entity, Status*), const OwnedEntity& entity, const std::string& type,
                              const std::string& function) {
    const auto found = status(get, entity, type, function);
    require(found.total_count == 0 && found.total_count_change == 0, type, function);
  }

  void check_statuses() {
    check_matched_status(l_.get_publication_matched_status, writer_, reader_handle_,
                         "dds_get_publication_matched_status");
    check_matched_status(l_.get_subscription_matched_status, reader_, writer_handle_,
                         "dds_get_subscription_matched_status");
    check_incompatible_status(l_.get_offered_incompatible_qos_status, unmatched_writer_,
                              "dds_get_offered_incompatible_qos_status");
    check_incompatible_status(l_.get_requested_incompatible_qos_status, reader_,
                              "dds_get_requested_incompatible_qos_status");
    const auto liveliness = status(l_.get_liveliness_changed_status, reader_, "liveliness status",
                                   "dds_get_liveliness_changed_status");
    require(liveliness.alive_count == 1 && liveliness.not_alive_count == 0 &&
                liveliness.last_publication == writer_handle_,
            "liveliness status", "dds_get_liveliness_changed_status");
    check_unchanged_status(l_.get_offered_deadline_missed_status, writer_, "deadline status",
                           "dds_get_offered_deadline_missed_status");
    check_unchanged_status(l_.get_requested_deadline_missed_status, reader_, "deadline status",
                           "dds_get_requested_deadline_missed_status");
    check_unchanged_status(l_.get_liveliness_lost_status, writer_, "liveliness lost status",
                           "dds_get_liveliness_lost_status");
    check_unchanged_status(l_.get_sample_lost_status, reader_, "sample lost status", "dds_get_sample_lost_status");
  }

  void write(unsigned char number) {
    unsigned char data[sample_size - sizeof(header)];
    std::memset(data, number, sizeof(data));
    IoVec parts[2]{};
    parts[0].iov_base = const_cast<unsigned char*>(header);
    parts[0].iov_len = sizeof(header);
    parts[1].iov_base = data;
    parts[1].iov_len = sizeof(data);
    Serdata_* sample = l_.serdata_from_ser_iov(type_, data_kind, 2, parts, sample_size);
    require(sample != nullptr, "sample", "ddsi_serdata_from_ser_iov");
    l_.check(l_.writecdr(writer_.get(), sample), "its writer can't write");
  }

  void check_samples() {
    const std::int64_t begin_ns = wall_clock_ns();
    for (std::size_t i = 0; i < sample_count; ++i) write(static_cast<unsigned char>(i + 1));
    check_received(l_.readcdr, "dds_readcdr", unread_sample, begin_ns);
    check_received(l_.takecdr, "dds_takecdr", read_sample, begin_ns);
    require(l_.wait_for_acks(writer_.get(), std::int64_t{1'000'000'000}) == 0, "result code", "dds_wait_for_acks");
  }

  using Receive = Result (*)(Entity, Serdata_**, std::uint32_t, SampleState*, std::uint32_t);

  void check_received(Receive receive, const std::string& function, std::uint32_t sample_state, std::int64_t begin_ns) {
    Canaried<Serdata_*, 4> samples;
    Canaried<SampleState, 4> states;
    const Result count = receive(reader_.get(), samples.data(), 4, states.data(), 0);
    require(count == static_cast<Result>(sample_count) && samples.is_intact_beyond(sample_count), "array of samples",
            function);
    require(states.is_intact_beyond(sample_count), "sample info", function);
    for (std::size_t i = 0; i < sample_count; ++i) {
      require(is_as_written(states, i, sample_state, begin_ns), "sample info", function);
      check_content(samples[i], static_cast<unsigned char>(i + 1));
    }
  }

  bool is_as_written(const Canaried<SampleState, 4>& states, std::size_t index, std::uint32_t sample_state,
                     std::int64_t begin_ns) const {
    const SampleState state = states[index];
    unsigned char is_valid = 0;  // as an octet, because a bool must not have another value than 0 and 1
    std::memcpy(&is_valid, reinterpret_cast<const unsigned char*>(&state) + offsetof(SampleState, valid_data), 1);
    return is_valid == 1 && state.sample_state == sample_state && state.instance_state == alive_instance &&
           (state.view_state == new_view || sample_state == read_sample) && state.source_stamp_ns >= begin_ns &&
           state.source_stamp_ns <= wall_clock_ns() && state.publication == writer_handle_ && state.instance != 0 &&
           state.instance == states[0].instance && state.disposed_generation_count == 0 &&
           state.no_writers_generation_count == 0 && state.sample_rank < sample_count && state.generation_rank == 0 &&
           state.absolute_generation_rank == 0;
  }

  void check_content(Serdata_* sample, unsigned char number) {
    require(is_readable(sample, sizeof(void*)), "array of samples", "dds_takecdr");
    require(l_.serdata_size(sample) == sample_size, "sample", "ddsi_serdata_size");
    Canaried<IoVec> view;
    Serdata_* reference = l_.serdata_to_ser_ref(sample, 0, sample_size, view.data());
    const IoVec found = view[0];
    require(view.is_intact_beyond() && found.iov_len == sample_size && is_readable(found.iov_base, sample_size),
            "view of a sample", "ddsi_serdata_to_ser_ref");
    unsigned char expected[sample_size];
    std::memset(expected, number, sizeof(expected));
    std::memcpy(expected, header, sizeof(header));
    require(std::memcmp(found.iov_base, expected, sizeof(expected)) == 0, "sample", "ddsi_serdata_to_ser_ref");
    l_.serdata_to_ser_unref(reference, view.data());
    l_.serdata_unref(sample);
  }

  // Take all samples of a built-in topic, and return whether `matches(sample)` for one of them.
  template <typename Sample, typename Matches>
  void check_built_in(Entity topic, const std::string& type, const Matches& matches) {
    const OwnedEntity reader(l_, l_.create_reader(domain_.participant(), topic, nullptr, nullptr),
                             "its " + type + " can't be read");
    constexpr std::size_t most = 4;
    void* samples[most]{};
    Canaried<SampleState, most> states;
    const Result count = l_.take(reader.get(), samples, states.data(), most, most);
    require(count > 0 && count <= static_cast<Result>(most) && states.is_intact_beyond(static_cast<std::size_t>(count)),
            "sample info", "dds_take");
    bool has_match = false;
    for (Result i = 0; i < count; ++i) {
      require(states[static_cast<std::size_t>(i)].instance_state == alive_instance, "sample info", "dds_take");
      has_match = has_match || (is_readable(samples[i], sizeof(Sample)) && matches(*static_cast<Sample*>(samples[i])));
    }
    require(has_match, type, "dds_take");
    l_.check(l_.return_loan(reader.get(), samples, count), "its loans can't be returned");
  }

  void check_discovered_participant() {
    check_built_in<DiscoveredParticipant>(discovered_participants, "participant data", [this](const auto& found) {
      return is_equal(found.key, participant_guid()) && is_user_data(l_, found.qos, participant_data);
    });
  }

  void check_discovered_endpoint(Entity topic, const OwnedEntity& expected) {
    check_built_in<DiscoveredEndpoint>(topic, "endpoint data", [this, &expected](const auto& found) {
      return is_described(&found, expected);
    });
  }

  const Library& l_;
  ListenerCall<0, MatchedStatus> writer_matched_;
  ListenerCall<1, MatchedStatus> reader_matched_;
  ListenerCall<2, LivelinessStatus> liveliness_;
  ListenerCall<3, IncompatibleStatus> incompatible_;
  SilentDomain domain_;
  OwnedEntity publisher_;
  OwnedEntity subscriber_;
  OwnedEntity topic_;
  OwnedEntity writer_;
  OwnedEntity reader_;
  OwnedEntity unmatched_writer_;
  const Sertype_* type_ = nullptr;
  InstanceHandle reader_handle_ = 0;
  InstanceHandle writer_handle_ = 0;
};

}  // namespace

void run_self_test(const Library& library) { SelfTest(library).run(); }

}  // namespace tfloom::dds
