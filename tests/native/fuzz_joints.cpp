// Fuzzes the path from the bytes of joint_states to those of /tf: what is written must be readable, and have rotations of
// unit length.
//
// An input: which interval; then the bytes of a JointState. For the arguments, see fuzzing.hpp.
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include "cdr/cursor.hpp"
#include "cdr/tf_message.hpp"
#include "fuzzing.hpp"
#include "robot/state_sink.hpp"

namespace {

using namespace tfloom;
using robot::JointKind;

struct Target {
  std::size_t refused = 0;
  std::shared_ptr<robot::StateTransforms> states = std::make_shared<robot::StateTransforms>(
      std::vector<robot::MovingJoint>{
          {"elbow", "upper", "lower", {JointKind::revolute, {{0.4, 0, 0}, {}}, {0, 1, 0}}},
          {"rail", "lower", "slide", {JointKind::prismatic, {{0.3, 0, 0}, {}}, {1, 0, 0}}},
          {"roll", "slide", "spin", {JointKind::revolute, {}, {1, 0, 0}}},
          {"shoulder", "base", "upper", {JointKind::revolute, {{0, 0, 0.5}, {0, 0.05, 0, 0.99875}}, {0, 1, 0}}},
      },
      std::vector<robot::Mimicry>{{0, 3, -0.5, 0.2}});
  robot::StateSink always{states, std::nullopt, [this](auto kind, auto data) { take(kind, data); }};
  robot::StateSink paced{states, 1'000'000, [this](auto kind, auto data) { take(kind, data); }};

  void take(robot::OutputKind kind, const std::vector<std::byte>& data) {
    if (kind == robot::OutputKind::refused) ++refused;
    if (kind != robot::OutputKind::transforms) return;
    std::vector<tf2::Entry> entries;
    try {
      cdr::read_tf_message(data, entries);
    } catch (const cdr::DecodeError&) {
      fuzzing::fail("fuzz_joints", "what was written is unreadable");
    }
    if (entries.empty() || entries.size() > 4) fuzzing::fail("fuzz_joints", "there are four joints");
    for (const tf2::Entry& entry : entries) {
      const tf2::Quaternion& q = entry.value.rotation;
      if (!(std::abs(dot(q, q) - 1.0) < 1e-6)) fuzzing::fail("fuzz_joints", "a rotation has not unit length");
    }
  }
};

bool run(std::span<const std::uint8_t> bytes) {
  static Target target;
  if (bytes.empty()) return false;
  // A copy that ends with its allocation, so that the sanitizer sees one byte too many.
  std::vector<std::byte> data(bytes.size() - 1);
  if (!data.empty()) std::memcpy(data.data(), bytes.data() + 1, data.size());
  SampleInfo info;
  info.received_stamp_ns = bytes[0];
  const std::size_t refused = target.refused;
  (bytes[0] % 2 == 0 ? target.always : target.paced).push(data, info);
  return target.refused == refused;
}

}  // namespace

int main(int count, char** arguments) {
  const fuzzing::Bytes empty(1 + 4 + 4 * 7, 0);  // big-endian, with no joint
  return fuzzing::fuzz("fuzz_joints", run, {empty}, count, arguments);
}
