// Participants, readers and writers of libddsc.

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "bindings/bindings.hpp"
#include "bindings/gil.hpp"
#include "bindings/bytes.hpp"
#include "bindings/objects.hpp"
#include "core/kept_memory.hpp"
#include "dds/graph.hpp"
#include "dds/packets.hpp"
#include "dds/participant.hpp"
#include "dds/reader.hpp"
#include "dds/self_test.hpp"
#include "dds/writer.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

// What Python holds. It may be freed by any thread at any time, by the garbage collector too.
using Participant = ClosedWithoutGil<dds::Participant>;
using Writer = ClosedWithoutGil<dds::Writer>;
using Reader = ClosedWithoutGil<dds::Reader>;
using Graph = ClosedWithoutGil<dds::Graph>;

// The fields of tfloom.rmw.qos.QoS.
using QosFields =
    std::tuple<int, int, int, std::int32_t, std::int64_t, std::int64_t, int, std::int64_t>;

dds::Qos to_qos(const QosFields& fields) {
  const auto [reliability, durability, history, depth, deadline, lifespan, liveliness, lease] = fields;
  return {static_cast<dds::Reliability>(reliability),
          static_cast<dds::Durability>(durability),
          static_cast<dds::History>(history),
          depth,
          deadline,
          lifespan,
          static_cast<dds::Liveliness>(liveliness),
          lease};
}

QosFields from_qos(const dds::Qos& qos) {
  return {static_cast<int>(qos.reliability), static_cast<int>(qos.durability), static_cast<int>(qos.history),
          qos.depth,                         qos.deadline_ns,                  qos.lifespan_ns,
          static_cast<int>(qos.liveliness),  qos.liveliness_lease_ns};
}

nb::bytes to_bytes(const Gid& gid) { return nb::bytes(gid.data(), gid.size()); }
nb::bytes to_bytes(const std::string& text) { return nb::bytes(text.data(), text.size()); }
nb::bytes to_bytes(std::span<const std::byte> data) { return nb::bytes(data.data(), data.size()); }

auto key_of(const nb::bytes& bytes) { return bytes_of<8>(bytes, "a client's key has 8 bytes"); }
Gid to_gid(const nb::bytes& bytes) { return bytes_of<16>(bytes, "a gid has 16 bytes"); }

std::string to_string(const nb::bytes& bytes) { return {bytes.c_str(), bytes.size()}; }

template <typename ContentOf>
nb::object take_with(Reader& reader, ContentOf content_of) {
  nb::object taken = nb::none();
  reader.take([&](std::span<const std::byte> data, const SampleInfo& info) {
    keep_memory_of(data.size());
    taken = nb::make_tuple(content_of(data), info.source_stamp_ns, info.received_stamp_ns,
                           to_bytes(info.publisher_gid));
  });
  return taken;
}

nb::object take_sample(Reader& reader) {
  return take_with(reader, [](std::span<const std::byte> data) -> nb::object { return to_bytes(data); });
}

// A large sample is decoded where the library has it, without a copy as `bytes`: benchmarks/native, "decoded in place". It
// is released by the end of the take. Small ones are not worth it, and must not be released after another thread has left
// the domain, which a finalizer in the middle of decoding may let run: the library returns them to the domain's pool.
nb::object take_decoded(Reader& reader, const nb::type_object& message_class) {
  auto* type = reinterpret_cast<PyTypeObject*>(message_class.ptr());
  const ObjectPlan& plan = plan_of(type);  // before the take, because it may fail
  return take_with(reader, [&](std::span<const std::byte> data) -> nb::object {
    if (data.size() < min_kept_memory) return to_bytes(data);
    try {
      return decode_message(plan, type, data);
    } catch (const cdr::DecodeError&) {
      return to_bytes(data);  // whoever decodes it gets the error
    }
  });
}

bool write(Writer& writer, const nb::bytes& data) {
  const std::span view(static_cast<const std::byte*>(data.data()), data.size());
  const ReleasedGil released;
  return writer.write(view);
}

// A large message is copied once, with the GIL, under which its arrays don't change.
bool write_message(Writer& writer, const nb::handle& message) {
  if (!is_large(message)) return write(writer, encode_message(message));
  std::optional<Writer::Sample> sample;
  {
    const EncodedMessage encoded(message);
    sample.emplace(writer.make(encoded.parts()));
  }
  const ReleasedGil released;
  return writer.send(std::move(*sample));
}

// Share the sink with a reader, which may release it on any thread.
void feed(Reader& reader, nb::typed<nb::object, Sink> sink) {
  auto* receiver = nb::cast<Sink*>(sink);
  std::shared_ptr<Sink> shared(receiver, [owner = sink.release().ptr()](Sink*) {
    const AcquiredGil gil;
    if (gil) Py_DECREF(owner);
  });
  const ReleasedGil released;
  reader.feed(std::move(shared));
}

template <typename Endpoint>
nb::list matched(Endpoint& endpoint) {
  nb::list peers;
  for (const dds::Peer& peer : endpoint.matched()) {
    peers.append(nb::make_tuple(to_bytes(peer.gid), to_bytes(peer.user_data)));
  }
  return peers;
}

template <typename Endpoint>
nb::object take_event(Endpoint& endpoint, int event) {
  const auto status = endpoint.take_event(static_cast<dds::Event>(event));
  if (!status) return nb::none();
  return nb::make_tuple((*status)[0], (*status)[1], (*status)[2], (*status)[3]);
}

template <typename Endpoint>
void bind_endpoint(nb::class_<Endpoint>& endpoint) {
  endpoint
      .def_prop_ro("gid", [](const Endpoint& self) { return to_bytes(self.gid()); }, "16 bytes.")
      .def("matched_count", &Endpoint::matched_count, "Return how many peers are matched now.")
      .def("matched", &matched<Endpoint>, nb::sig("def matched(self) -> list[tuple[bytes, bytes]]"),
           "Return the gid and the user data of each peer that is matched now.")
      .def(
          "notify_event",
          [](Endpoint& self, int event, ReadyQueue::Shared queue, ReadyQueue::Token token) {
            self.notify_event(static_cast<dds::Event>(event), std::move(queue), token);
          },
          "event"_a, "queue"_a.none(), "token"_a,
          "Post `token` to `queue` when the status of `event` (tfloom.rmw.events.Event) may have changed; None ends "
          "it.")
      .def("take_event", &take_event<Endpoint>, "event"_a,
           nb::sig("def take_event(self, event: int) -> tuple[int, int, int, int] | None"),
           "Return the fields of the event's status, padded with zeros, or None if nothing has changed.");
}

nb::tuple snapshot(Graph& graph) {
  dds::Graph::Snapshot state;
  {
    const ReleasedGil released;
    state = graph.snapshot();
  }
  nb::list participants;
  for (const auto& [gid, info] : state.participants) {
    participants.append(nb::make_tuple(to_bytes(gid), to_bytes(info.user_data), to_bytes(info.node_list)));
  }
  nb::list endpoints;
  for (const auto& info : state.endpoints) {
    endpoints.append(nb::make_tuple(to_bytes(info.gid), to_bytes(info.participant), info.is_writer,
                                    to_bytes(info.topic_name), to_bytes(info.type_name),
                                    to_bytes(info.user_data), from_qos(info.qos)));
  }
  return nb::make_tuple(participants, endpoints);
}

using ReleaseGil = nb::call_guard<ReleasedGil>;

// The constructor of a writer, a reader or a graph.
template <typename T, typename... Options>
void init_on_topic(T* self, Participant& participant, const std::string& topic_name, const std::string& type_name,
                   const QosFields& qos, const nb::bytes& user_data, Options... options) {
  const std::string user_text = to_string(user_data);
  const ReleasedGil released;
  new (self) T(participant, {topic_name, type_name}, to_qos(qos), user_text, options...);
}

void bind_participant(nb::module_& m) {
  nb::class_<Participant>(m, "DdsParticipant", "This process on one DDS domain.")
      .def(
          "__init__",
          [](Participant* self, const std::string& library_path, std::uint32_t domain_id,
             const std::string& config, const nb::bytes& user_data, bool is_local) {
            const std::string user_text = to_string(user_data);
            const ReleasedGil released;
            new (self) Participant(dds::Library::open(library_path), domain_id, config, user_text, is_local);
          },
          "library_path"_a, "domain_id"_a, "config"_a, "user_data"_a, "is_local"_a = false,
          "Join a domain with the libddsc at `library_path`, Cyclone's XML `config` and the published `user_data`. With "
          "`is_local`, bind the domain's sockets to the loopback interface where the system allows it.")
      .def_prop_ro("gid", [](const Participant& self) { return to_bytes(self.gid()); }, "16 bytes.")
      .def_prop_ro(
          "loopback_failure", [](const Participant& self) { return self.loopback_failure(); },
          "Why the domain's sockets are not bound as `is_local` requests; empty if they are, or without `is_local`.")
      .def("close", &Participant::close, ReleaseGil(),
           "Leave the domain, after endpoints and graph are closed. Closing again does nothing.");
}

void bind_writer(nb::module_& m) {
  nb::exception<dds::Error>(m, "DdsError", PyExc_RuntimeError);
  nb::class_<Writer> writer(m, "DdsWriter", "A writer of a DDS topic.");
  bind_endpoint(writer);
  writer
      .def("__init__", &init_on_topic<Writer, bool>, "participant"_a, "topic_name"_a, "type_name"_a, "qos"_a,
           "user_data"_a, "waits"_a = true, nb::keep_alive<1, 2>(),
           "Create a writer of a topic, given by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS. `waits` is "
           "whether a write waits for readers that lag behind.")
      .def("write", &write, "data"_a,
           "Send a sample: encapsulation header 00 01 xx xx and little-endian CDR. Return False if readers lag behind and "
           "this writer doesn't wait for them: then nothing was sent.")
      .def("write_message", &write_message, "message"_a,
           "Encode and send a message. Its large arrays are copied once. For a writer that is an end of no service.")
      .def(
          "join_service",
          [](Writer& self, Reader& reader, const std::string& service, const std::optional<nb::bytes>& client) {
            auto& forms = rtps::ServiceForms::of_process();
            auto end = client ? forms.add_client(service, self.gid(), reader.gid(), key_of(*client))
                              : forms.add_server(service, self.gid(), reader.gid());
            self.join(end);
            reader.join(std::move(end));
          },
          "reader"_a, "service"_a, "client"_a.none(),
          "Become an end of a service, with the reader of the other topic: a client whose headers have the 8 bytes "
          "`client`, or a server. To be called before the first sample is written or taken.")
      .def("assert_liveliness", &Writer::assert_liveliness, ReleaseGil(), "Signal that this writer is alive.")
      .def("probe", &Writer::probe, ReleaseGil(),
           "Send a message that readers acknowledge and drop: the end of an instance that does not exist.")
      .def("wait_for_acks", &Writer::wait_for_acks, "timeout_ns"_a, ReleaseGil(),
           "Wait until all reliable readers have acknowledged all samples. Return False on a timeout.")
      .def("close", &Writer::close, ReleaseGil(), "Leave the topic. Closing again does nothing.");
}

void bind_reader(nb::module_& m) {
  nb::class_<Reader> reader(m, "DdsReader", "A reader of a DDS topic.");
  bind_endpoint(reader);
  reader
      .def("__init__", &init_on_topic<Reader>, "participant"_a, "topic_name"_a, "type_name"_a, "qos"_a, "user_data"_a,
           nb::keep_alive<1, 2>(),
           "Create a reader of a topic, given by its names on the wire; `qos` is a resolved tfloom.rmw.qos.QoS.")
      .def("notify", &Reader::notify, "queue"_a.none(), "token"_a,
           "Post `token` to `queue` when there are samples to take; None ends it.")
      .def("take", &take_sample, nb::sig("def take(self) -> tuple[bytes, int, int, bytes] | None"),
           "Remove the oldest sample: (data, source stamp, received stamp, gid), or None.")
      .def("take_decoded", &take_decoded, "message_class"_a,
           nb::sig("def take_decoded(self, message_class: type) -> tuple[typing.Any, int, int, bytes] | None"),
           "As `take`; but a large sample that can be decoded is a message of `message_class` instead of bytes.")
      .def("announce_filter", &Reader::announce_filter, "expression"_a, "parameters"_a, ReleaseGil(),
           nb::sig("def announce_filter(self, expression: str, parameters: list[str]) -> None"),
           "Tell writers which samples are wanted, in DDS's subset of SQL; an empty expression accepts all.")
      .def("feed", &feed, "sink"_a,
           "Push every further sample into `sink`, on a thread without Python.")
      .def("close", &Reader::close, ReleaseGil(),
           "Leave the topic. Afterwards neither queue nor sink is used. Closing again does nothing.");
}

void bind_graph(nb::module_& m) {
  nb::class_<Graph>(m, "DdsGraph", "The participants and endpoints discovered on a DDS domain.")
      .def("__init__", &init_on_topic<Graph>, "participant"_a, "topic_name"_a, "type_name"_a, "qos"_a, "user_data"_a,
           nb::keep_alive<1, 2>(),
           "Start to listen. The names are those of the topic in which participants list their nodes.")
      .def("snapshot", &snapshot,
           nb::sig("def snapshot(self) -> tuple[list[tuple[bytes, bytes, bytes]], list[tuple[bytes, bytes, bool, "
                   "bytes, bytes, bytes, tuple[int, int, int, int, int, int, int, int]]]]"),
           "Return participants (gid, user data, node list) and endpoints (gid, participant's gid, whether a writer, "
           "topic, type, user data, qos), texts as the received bytes.")
      .def("changes", &Graph::changes, ReleaseGil(), "Return a number that grows with each change.")
      .def("notify", &Graph::notify, "queue"_a.none(), "token"_a,
           "Post `token` to `queue` whenever the graph has changed; None ends it.")
      .def("close", &Graph::close, ReleaseGil(), "Stop listening. Closing again does nothing.");
}

}  // namespace

void bind_library(nb::module_& m) {
  m.def(
      "open_dds_library",
      [](const std::string& path, bool is_common_build) { return dds::Library::open(path, is_common_build).version; },
      "path"_a, "is_common_build"_a = false, ReleaseGil(),
      "Open the libddsc at `path`, once, and return its version, empty if it records none. It passes a self-test first, "
      "unless it is one of PyPI's builds (`is_common_build`) in a version that was tried. Raise RuntimeError if it can't "
      "be used.");
  m.def(
      "intercept_dds_packets",
      [](const std::string& path) { return dds::intercept_packets(dds::Library::open(path).handle); }, "path"_a, ReleaseGil(),
      "Translate services for peers on Fast DDS in the packets of the libddsc at `path`. Return the reason why this can't "
      "be done here; empty if it is done.");
  m.def(
      "dds_knows_address",
      [](const nb::bytes& gid) {
        return rtps::ServiceForms::of_process().knows(rtps::prefix_of(to_gid(gid)));
      },
      "gid"_a, "Return whether an address of the participant of this endpoint is known.");
  m.def(
      "dds_read_versions", [] { rtps::ServiceForms::of_process().read_versions(); },
      "From here on, note the versions of DDS that participants announce, where `intercept_dds_packets` is done.");
  m.def(
      "dds_version",
      [](const nb::bytes& gid) {
        return rtps::ServiceForms::of_process().version_of(rtps::prefix_of(to_gid(gid)));
      },
      "gid"_a, "Return the version of DDS that this participant has announced, as 11.0.1; empty if it has not.");
  m.def(
      "dds_inline_client",
      [](const nb::bytes& key) -> std::optional<nb::bytes> {
        const auto gid = rtps::ServiceForms::of_process().inline_client(key_of(key));
        if (!gid) return std::nullopt;
        return to_bytes(*gid);
      },
      "key"_a,
      "Return the gid that awaits the responses for a client on Fast DDS, by the 8 bytes in its headers; None for "
      "others.");
  m.def(
      "test_dds_library", [](const std::string& path) { dds::run_self_test(dds::Library::open(path)); }, "path"_a,
      ReleaseGil(),
      "Run the self-test of the libddsc at `path`, whichever version it is. Raise RuntimeError with what differs.");
}

void bind_dds(nb::module_& m) {
  bind_library(m);
  bind_participant(m);
  bind_writer(m);
  bind_reader(m);
  bind_graph(m);
}

}  // namespace tfloom::bindings
