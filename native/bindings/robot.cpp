// The kinematics of robots.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/bindings.hpp"
#include "bindings/callback.hpp"
#include "bindings/gil.hpp"
#include "cdr/cursor.hpp"
#include "dds/writer.hpp"
#include "robot/chain.hpp"
#include "robot/state_sink.hpp"
#include "robot/state_transforms.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using robot::Chain;
using robot::Joint;
using robot::JointKind;
using robot::StateTransforms;
using tf2::Transform;
using Writer = ClosedWithoutGil<dds::Writer>;

// Kind, origin, axis.
using JointRow = std::tuple<std::string, std::array<double, 7>, std::array<double, 3>>;
using Positions = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Poses = nb::ndarray<double, nb::shape<-1, -1, 7>, nb::c_contig, nb::device::cpu>;

JointKind kind_of(const std::string& name) {
  if (name == "fixed") return JointKind::fixed;
  if (name == "revolute" || name == "continuous") return JointKind::revolute;
  if (name == "prismatic") return JointKind::prismatic;
  if (name == "planar") return JointKind::planar;
  if (name == "floating") return JointKind::floating;
  throw nb::value_error(("there is no joint type " + name).c_str());
}

Joint joint_of(const JointRow& row) {
  const auto& [kind, o, axis] = row;
  return {kind_of(kind), {{o[0], o[1], o[2]}, {o[3], o[4], o[5], o[6]}}, {axis[0], axis[1], axis[2]}};
}

Chain make_chain(const std::vector<std::tuple<JointRow, std::size_t, std::size_t, double, double>>& rows,
                 std::size_t variable_count) {
  std::vector<robot::ChainJoint> joints;
  joints.reserve(rows.size());
  for (const auto& [joint, parent, variable, multiplier, offset] : rows) {
    joints.push_back({joint_of(joint), parent, variable, multiplier, offset});
  }
  return {std::move(joints), variable_count};
}

template <auto Fill>
void fill(const Chain& chain, const Positions& positions, const Poses& out, std::size_t poses) {
  const std::size_t rows = positions.shape(0), variables = positions.shape(1);
  if (variables != chain.variable_count() || out.shape(0) != rows || out.shape(1) != poses) {
    throw nb::value_error("the arrays must have a column for each variable, and a pose for each link or joint");
  }
  const ReleasedGil release;
  auto* to = reinterpret_cast<Transform*>(out.data());
  for (std::size_t i = 0; i < rows; ++i) {
    (chain.*Fill)({positions.data() + i * variables, variables}, {to + i * poses, poses});
  }
}

void make_states(StateTransforms* self,
                 const std::vector<std::tuple<std::string, std::string, std::string, JointRow>>& rows,
                 const std::vector<std::tuple<std::size_t, std::size_t, double, double>>& mimicries) {
  std::vector<robot::MovingJoint> joints;
  for (const auto& [name, frame_id, child_frame_id, joint] : rows) {
    joints.push_back({name, frame_id, child_frame_id, joint_of(joint)});
  }
  std::vector<robot::Mimicry> followers;
  for (const auto& [joint, source, multiplier, offset] : mimicries) {
    followers.push_back({joint, source, multiplier, offset});
  }
  new (self) StateTransforms(std::move(joints), std::move(followers));
}

nb::object convert(StateTransforms& self, const nb::bytes& data, std::int64_t now_ns,
                   std::optional<std::int64_t> interval_ns) {
  std::vector<std::byte> message;
  try {
    message = self.convert({static_cast<const std::byte*>(data.data()), data.size()}, now_ns, interval_ns);
  } catch (const cdr::DecodeError& error) {
    throw std::invalid_argument("JointState: byte " + std::to_string(error.offset) + ": " + error.what());
  }
  if (message.empty()) return nb::none();
  return nb::bytes(message.data(), message.size());
}

// The function that a sink emits to: it passes bytes to one of two callables, or transforms to a writer without Python.
// Calls that wait for the other thread are limited in number, because writing may wait for slow readers.
class OutputCalls {
 public:
  // `writer` may be of another wire: then `publish` is called.
  OutputCalls(nb::callable publish, nb::callable report, const nb::object& writer)
      : publish_(std::move(publish)), report_(std::move(report)) {
    if (!nb::try_cast(writer, writer_)) writer_ = nullptr;
    if (writer_ != nullptr) writer_owner_.emplace(nb::cast<nb::callable>(writer.attr("write")));
  }

  void operator()(robot::OutputKind kind, std::vector<std::byte> data) const {
    constexpr int max_waiting = 100;
    DeferredQueue* queue = DeferredQueue::current();
    if (queue == nullptr) {
      call(kind, data);
    } else if (waiting_->fetch_add(1) < max_waiting) {
      queue->defer([self = *this, kind, kept = std::move(data)] {
        self.call(kind, kept);
        self.waiting_->fetch_sub(1);
      });
    } else {
      waiting_->fetch_sub(1);
    }
  }

 private:
  void call(robot::OutputKind kind, const std::vector<std::byte>& data) const {
    if (kind == robot::OutputKind::transforms && writer_ != nullptr) {
      try {
        writer_->write(data);
      } catch (const std::exception&) {  // the writer is closed, as at the end of a program
      }
      return;
    }
    const AcquiredGil gil;
    if (!gil) return;
    const nb::bytes bytes(data.data(), data.size());
    switch (kind) {
      case robot::OutputKind::transforms:
        return publish_(bytes);
      case robot::OutputKind::refused:
        return report_("refused", bytes);
      case robot::OutputKind::left_out:
        return report_("left out", bytes);
      case robot::OutputKind::moved_back:
        return report_("moved back", bytes);
    }
  }

  Callback publish_, report_;
  Writer* writer_ = nullptr;
  std::optional<Callback> writer_owner_;  // a bound method, for a reference to the writer that any thread may release
  std::shared_ptr<std::atomic<int>> waiting_ = std::make_shared<std::atomic<int>>(0);
};

void bind_chain(nb::module_& m) {
  nb::class_<Chain>(m, "JointChain", "The joints of a robot in order from the root, for their poses at many positions.")
      .def(nb::new_(&make_chain), "joints"_a, "variable_count"_a,
           "Each joint is its form, the index of its parent link, its first variable, and multiplier and offset of a "
           "mimic joint. Joint i moves link i + 1; link 0 is the root. A form is the type, the origin (7 numbers) and "
           "the axis. Raises ValueError if an index is out of range.")
      .def_prop_ro("joint_count", &Chain::joint_count, "Number of joints.")
      .def_prop_ro("variable_count", &Chain::variable_count, "Number of position variables.")
      .def("fill_joints",
           [](const Chain& self, const Positions& positions, const Poses& out) {
             fill<&Chain::joint_poses>(self, positions, out, self.joint_count());
           },
           "positions"_a, "out"_a, "Fill `out` (N, joints, 7) with parent_from_child at `positions` (N, variables).")
      .def("fill_links",
           [](const Chain& self, const Positions& positions, const Poses& out) {
             fill<&Chain::link_poses>(self, positions, out, self.joint_count() + 1);
           },
           "positions"_a, "out"_a, "Fill `out` (N, links, 7) with root_from_link at `positions` (N, variables).");
}

void bind_states(nb::module_& m) {
  nb::class_<StateTransforms>(m, "StateTransforms",
                              "Converts `sensor_msgs/msg/JointState` to `tf2_msgs/msg/TFMessage`, as bytes.")
      .def("__init__", &make_states, "joints"_a, "mimicries"_a,
           "Each joint is its name, its frame_id, its child_frame_id, and its form as that of a JointChain's. A "
           "mimicry is the index of a joint, that of the joint it follows, a multiplier and an offset; one that "
           "follows a mimic joint comes after it.")
      .def("convert", &convert, "data"_a, "now_ns"_a, "interval_ns"_a.none(),
           nb::sig("def convert(self, data: bytes, now_ns: int, interval_ns: int | None) -> bytes | None"),
           "Return the transforms of a serialized message; None if there are none or they are not due: the joint that "
           "was published least recently was so less than `interval_ns` before the message's stamp.\n\n"
           "Raises ValueError if the bytes are not a JointState, or names and positions differ in number.")
      .def("forget_stamps", &StateTransforms::forget_stamps, "Make the next message due, after a jump in time.")
      .def_prop_ro("left_out", &StateTransforms::left_out,
                   "A joint of the last message that was left out because its position is not finite; or empty.")
      .def(
          "sink",
          [](std::shared_ptr<StateTransforms> self, std::optional<std::int64_t> interval_ns, nb::callable publish,
             nb::callable report, const nb::object& writer) {
            return std::make_unique<robot::StateSink>(std::move(self), interval_ns,
                                                      OutputCalls(std::move(publish), std::move(report), writer));
          },
          "interval_ns"_a.none(), "publish"_a, "report"_a, "writer"_a.none() = nb::none(),
          nb::sig("def sink(self, interval_ns: int | None, publish: collections.abc.Callable[[bytes], object], report: "
                  "collections.abc.Callable[[str, bytes], object], writer: object = None) -> StateSink"),
          "Return a sink for `Reader.feed` that converts messages, as `convert` does, on the wire's thread.\n\n"
          "`publish(data)` and `report(what, data)` are called on a thread that may wait, in order; messages are lost "
          "while a hundred calls wait. `what` is \"refused\", with the message; \"left out\", with a joint's name; or "
          "\"moved back\", for a time before that of the last message. The callables must not refer to the sink. "
          "With a `DdsWriter`, transforms are written by it, and `publish` is not called.");
  nb::class_<robot::StateSink, Sink>(m, "StateSink", "A sink of `sensor_msgs/msg/JointState`.")
      .def("set_simulated_time", &robot::StateSink::set_simulated_time, "now_ns"_a.none(),
           "Set the time of messages that arrive from now on [ns since epoch]; None: the system's.");
}

}  // namespace

void bind_robot(nb::module_& m) {
  bind_chain(m);
  bind_states(m);
}

}  // namespace tfloom::bindings
