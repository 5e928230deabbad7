// Statistics of the transforms on /tf, by publisher and edge.

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>
#include <vector>

#include "bag/tf_records.hpp"
#include "bindings/bytes.hpp"
#include "bindings/gil.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"
#include "cdr/cursor.hpp"
#include "cdr/tf_message.hpp"
#include "cdr/tf_observer.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using cdr::TfChild;
using cdr::TfEdge;
using cdr::TfObserver;
using cdr::TfObserverSink;
using cdr::TfSnapshot;
using cdr::TfTraffic;
using tf2::EdgeStatistics;
using tf2::Spread;
using tf2::Step;

nb::bytes to_bytes(const Gid& gid) { return nb::bytes(gid.data(), gid.size()); }

nb::tuple translation_of(const EdgeStatistics& statistics) {
  const auto& p = statistics.value.translation;
  return nb::make_tuple(p.x, p.y, p.z);
}

nb::tuple rotation_of(const EdgeStatistics& statistics) {
  const auto& q = statistics.value.rotation;
  return nb::make_tuple(q.x, q.y, q.z, q.w);
}

TfSnapshot snapshot_of(const TfObserver& observer) {
  const ReleasedGil release;
  return observer.snapshot();
}

std::unique_ptr<TfObserverSink> make_observer_sink(const std::shared_ptr<TfObserver>& observer, bool is_static,
                                          const BufferHandle* buffer) {
  return std::make_unique<TfObserverSink>(observer, is_static, buffer == nullptr ? nullptr : buffer->buffer);
}

Gid gid_of(const nb::bytes& bytes) { return bytes_of<16>(bytes, "a gid must have 16 bytes"); }

std::vector<tf2::Entry> read_entries(std::span<const std::byte> bytes, bool is_ros1, bool& is_readable) {
  std::vector<tf2::Entry> entries;
  try {
    if (is_ros1) {
      bag::read_ros1_tf_message(bytes, entries);
      for (tf2::Entry& entry : entries) {  // names of ROS 1 may begin with a slash, which a buffer drops
        if (entry.frame_id.starts_with('/')) entry.frame_id.remove_prefix(1);
        if (entry.child_frame_id.starts_with('/')) entry.child_frame_id.remove_prefix(1);
      }
    } else {
      cdr::read_tf_message(bytes, entries);
    }
    is_readable = true;
  } catch (const cdr::PathError&) {
    entries.clear();
    is_readable = false;
  }
  return entries;
}

bool record(TfObserver& observer, const nb::bytes& data, const nb::bytes& publisher_gid, StampArgument received,
            bool is_static, bool is_ros1, const BufferHandle* buffer) {
  const SampleInfo info{0, received.value, gid_of(publisher_gid)};
  const std::span bytes(static_cast<const std::byte*>(data.data()), data.size());
  const ReleasedGil release;
  bool is_readable = false;
  const std::vector<tf2::Entry> entries = read_entries(bytes, is_ros1, is_readable);
  observer.record(entries, info, is_static, bytes.size(), is_readable);
  if (buffer != nullptr) buffer->buffer->set(entries, "recorded", is_static);
  return is_readable;
}

void accept_only(TfObserverSink& sink, std::optional<std::vector<nb::bytes>> publishers) {
  if (!publishers) return sink.accept_only(std::nullopt);
  std::vector<Gid> gids;
  for (const nb::bytes& publisher : *publishers) gids.push_back(gid_of(publisher));
  sink.accept_only(std::move(gids));
}

void bind_figures(nb::module_& m) {
  nb::class_<Spread>(m, "Spread", "Number, mean, deviation and extremes of values; all are 0 without a value.")
      .def_ro("count", &Spread::count, "Number of values.")
      .def_ro("mean", &Spread::mean, "Their mean.")
      .def_ro("least", &Spread::least, "The least.")
      .def_ro("greatest", &Spread::greatest, "The greatest.")
      .def_prop_ro("deviation", &Spread::deviation, "Their standard deviation, of the population.");
  nb::class_<Step>(m, "Step", "The motion between two consecutive transforms, in order of their stamps.")
      .def_ro("stamp_ns", &Step::stamp, "Stamp of the later one [ns since epoch].")
      .def_ro("elapsed_ns", &Step::elapsed, "Time between their stamps [ns]; 0: there was no step, or it is static.")
      .def_ro("distance", &Step::distance, "Translation between them [m].")
      .def_ro("angle_rad", &Step::angle_rad, "Rotation between them, 0 to pi [rad].")
      .def_prop_ro("speed", &Step::speed, "Distance by time [m/s]; 0 if `elapsed_ns` is 0.");
}

void bind_statistics(nb::module_& m) {
  nb::class_<EdgeStatistics>(m, "EdgeStatistics",
                             "What is known of the transforms that one publisher has sent for one edge.\n\n"
                             "Stamps and times of receipt are [ns since epoch].")
      .def_ro("count", &EdgeStatistics::count, "Number of transforms.")
      .def_ro("first_stamp_ns", &EdgeStatistics::first_stamp, "The stamp received first.")
      .def_ro("last_stamp_ns", &EdgeStatistics::last_stamp, "The stamp received last.")
      .def_ro("oldest_stamp_ns", &EdgeStatistics::oldest_stamp, "The oldest stamp.")
      .def_ro("newest_stamp_ns", &EdgeStatistics::newest_stamp, "The newest stamp.")
      .def_ro("first_received_ns", &EdgeStatistics::first_received, "Time of the first receipt.")
      .def_ro("last_received_ns", &EdgeStatistics::last_received, "Time of the last receipt.")
      .def_ro("stamp_period", &EdgeStatistics::stamp_period,
              "Times from the newest stamp to a newer one [s]; steps back and repetitions are not counted.")
      .def_ro("receipt_period", &EdgeStatistics::receipt_period, "Times between receipts [s].")
      .def_ro("delay", &EdgeStatistics::delay,
              "Times from the stamp to now, at receipt [s]; negative: stamped ahead of now. Zero stamps are not counted.")
      .def_ro("out_of_order", &EdgeStatistics::out_of_order, "Number of transforms older than the newest one.")
      .def_ro("steps_back", &EdgeStatistics::steps_back,
              "Number of transforms older than the one received before.")
      .def_ro("repeated", &EdgeStatistics::repeated,
              "Number of moving transforms with the same stamp as the newest one.")
      .def_ro("too_old", &EdgeStatistics::too_old,
              "Number of transforms older than the child's newest, from any publisher, by more than the cache time: a "
              "buffer rejects them.")
      .def_ro("ahead", &EdgeStatistics::ahead, "Number of transforms stamped ahead of now.")
      .def_ro("zero_stamps", &EdgeStatistics::zero_stamps, "Number of transforms with the stamp 0.")
      .def_ro("largest_step_back_ns", &EdgeStatistics::largest_step_back,
              "The longest time by which a stamp was older than the newest one before it [ns].")
      .def_ro("non_finite", &EdgeStatistics::non_finite,
              "Number of transforms with a NaN or an infinity; they are in none of the figures that follow.")
      .def_ro("worst_norm_error", &EdgeStatistics::worst_norm_error,
              "The greatest difference of a quaternion's length from 1.")
      .def_ro("changes", &EdgeStatistics::changes, "Number of transforms that differ from the one before.")
      .def_prop_ro("translation", &translation_of, nb::sig("def translation(self) -> tuple[float, float, float]"),
                   "Translation x, y, z of the newest transform [m]; of a static one, of the last.")
      .def_prop_ro("rotation_xyzw", &rotation_of,
                   nb::sig("def rotation_xyzw(self) -> tuple[float, float, float, float]"),
                   "Rotation x, y, z, w of the same transform.")
      .def_ro("distance", &EdgeStatistics::distance, "Distances of the steps [m].")
      .def_ro("cosine", &EdgeStatistics::cosine, "Cosines of half the angles of the steps.")
      .def_ro("longest", &EdgeStatistics::longest, "The step of the greatest distance.")
      .def_ro("widest", &EdgeStatistics::widest, "The step of the greatest angle.")
      .def_ro("fastest", &EdgeStatistics::fastest, "The step of the greatest speed.");
}

void bind_snapshot(nb::module_& m) {
  nb::class_<TfTraffic>(m, "TfTraffic", "What one publisher has sent on /tf, or on /tf_static.")
      .def_prop_ro("gid", [](const TfTraffic& self) { return to_bytes(self.gid); }, "Its gid: 16 bytes.")
      .def_ro("is_static", &TfTraffic::is_static, "Whether this is on /tf_static.")
      .def_ro("has_left", &TfTraffic::has_left, "Whether it has left.")
      .def_ro("messages", &TfTraffic::messages, "Number of messages.")
      .def_ro("transforms", &TfTraffic::transforms, "Number of transforms.")
      .def_ro("bytes", &TfTraffic::bytes, "Bytes of the messages.")
      .def_ro("unreadable", &TfTraffic::unreadable, "Number of messages that are not a TFMessage.")
      .def_ro("max_transforms", &TfTraffic::max_transforms, "The greatest number of transforms in one message.")
      .def_ro("first_received_ns", &TfTraffic::first_received, "Time of the first receipt [ns since epoch].")
      .def_ro("last_received_ns", &TfTraffic::last_received, "Time of the last receipt [ns since epoch].")
      .def_ro("period", &TfTraffic::period, "Times between receipts of its messages [s].")
      .def_ro("transit", &TfTraffic::transit,
              "Times from writing, by the publisher's clock, to receipt, by this machine's [s].");
  nb::class_<TfEdge>(m, "TfEdge", "One edge of one publisher.")
      .def_ro("child", &TfEdge::child, "The child frame.")
      .def_ro("parent", &TfEdge::parent, "The parent frame.")
      .def_prop_ro("gid", [](const TfEdge& self) { return to_bytes(self.gid); }, "The publisher's gid: 16 bytes.")
      .def_ro("is_static", &TfEdge::is_static, "Whether it came on /tf_static.")
      .def_ro("statistics", &TfEdge::statistics, "Its figures.");
  nb::class_<TfChild>(m, "TfChild", "A frame that was a child, on either topic and from any publisher.")
      .def_ro("child", &TfChild::child, "The frame.")
      .def_ro("parent", &TfChild::parent, "Its parent in the transform received last.")
      .def_ro("reparented", &TfChild::reparented,
              "Number of transforms whose parent was another than that of the child's former one.")
      .def_ro("newest_stamp_ns", &TfChild::newest_stamp, "Newest stamp of its moving transforms; 0: none.");
  nb::class_<TfSnapshot>(m, "TfSnapshot", "What an observer has recorded; each list is in order of first receipt.")
      .def_ro("publishers", &TfSnapshot::publishers, "The publishers.")
      .def_ro("edges", &TfSnapshot::edges, "The edges.")
      .def_ro("children", &TfSnapshot::children, "The child frames.")
      .def_ro("unrecorded", &TfSnapshot::unrecorded, "Number of transforms beyond the observer's limits.");
}

}  // namespace

void bind_tf2_observer(nb::module_& m) {
  bind_figures(m);
  bind_statistics(m);
  bind_snapshot(m);
  nb::class_<TfObserverSink, Sink>(m, "TfObserverSink", "Passes the samples of one topic to an observer.")
      .def("accept_only", &accept_only, "publishers"_a.none(),
           "Ignore the samples of all publishers but these, given by their gids; None: of none.");
  nb::class_<cdr::TfClockSink, Sink>(m, "TfClockSink", "Passes the time on /clock to an observer.");
  nb::class_<TfObserver>(m, "TfObserver", "Statistics of all transforms on /tf and /tf_static, by publisher and edge.")
      .def(nb::new_([](StampArgument cache_time) { return std::make_shared<TfObserver>(cache_time.value); }),
           "cache_time_ns"_a = tf2::Buffer::default_cache_time)
      .def("sink", &make_observer_sink, "static"_a, "buffer"_a.none() = nb::none(),
           "Return a sink for `Reader.feed` that records samples of `tf2_msgs/msg/TFMessage` here.\n\n"
           "It also stores the transforms in `buffer`, if there is one, with the publisher's gid in hexadecimal as "
           "authority.")
      .def("clock_sink", [](const std::shared_ptr<TfObserver>& self) { return std::make_unique<cdr::TfClockSink>(self); },
           "Return a sink for `Reader.feed` that takes the simulated time from samples of `rosgraph_msgs/msg/Clock`.")
      .def("record", &record, "data"_a, "publisher_gid"_a, "received_ns"_a, "static"_a = false, "ros1"_a = false,
           "buffer"_a.none() = nb::none(),
           "Record a recorded message, and store its transforms in `buffer`, if there is one.\n\n"
           "`data` is a `tf2_msgs/msg/TFMessage`: encapsulation header and CDR, or ROS 1's form. Return whether it was "
           "readable.")
      .def("snapshot", &snapshot_of, "Return a copy of all that is recorded.")
      .def("clear", &TfObserver::clear, "Forget everything.")
      .def("simulated_time", &TfObserver::simulated_time,
           "Return the time with which stamps are compared [ns since epoch]; 0: unknown; None: the time of receipt.")
      .def("set_simulated_time", &TfObserver::set_simulated_time, "now_ns"_a.none(),
           "Set the time with which stamps are compared [ns since epoch]; 0: unknown, delays are not recorded; None: "
           "the time of receipt.");
}

}  // namespace tfloom::bindings
