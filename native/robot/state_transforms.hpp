// The transforms of a robot's moving joints, from sensor_msgs/msg/JointState to tf2_msgs/msg/TFMessage, as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/joint.hpp"
#include "tf2/name_index.hpp"

namespace tfloom::robot {

// A joint with one variable, and the frames that it connects.
struct MovingJoint {
  std::string name, frame_id, child_frame_id;
  Joint joint;
};

// A joint that follows another, by index: it stands at multiplier * source + offset.
struct Mimicry {
  std::size_t joint = 0, source = 0;
  double multiplier = 1.0, offset = 0.0;
};

// Thread-safe.
class StateTransforms {
 public:
  // Mimicries are in order: one whose source is itself a mimic joint comes after it. Throw std::invalid_argument if an
  // index is out of range, or a joint's kind has other than one variable.
  StateTransforms(std::vector<MovingJoint> joints, std::vector<Mimicry> mimicries);

  // Return the TFMessage for a JointState, its transforms in the order of the joints; empty if there are none, or if they
  // are not due: they are if the joint that was published least recently was so `interval_ns` before the message's stamp
  // or earlier; nullopt: always.
  //
  // Of several positions for one joint, the first is taken. Names of other joints are ignored. A joint whose position
  // is not finite is left out. Throw DecodeError if the bytes are not a JointState, or if the numbers of names and
  // of positions differ.
  std::vector<std::byte> convert(std::span<const std::byte> data, std::int64_t now_ns,
                                 std::optional<std::int64_t> interval_ns);

  void forget_stamps();  // after a jump in time: the next message is due
  [[nodiscard]] std::string left_out() const;  // a joint of the last message whose position was not finite; or empty

 private:
  void read(std::span<const std::byte> data);
  void take(std::size_t joint, double position);
  void follow();
  [[nodiscard]] std::vector<std::byte> write() const;
  [[nodiscard]] bool is_due(std::int64_t stamp_ns, std::int64_t now_ns, std::optional<std::int64_t> interval_ns) const;

  const std::vector<MovingJoint> joints_;
  const std::vector<Mimicry> mimicries_;
  tf2::NameIndex index_;  // constant after construction
  std::size_t size_hint_ = 0;

  mutable std::mutex mutex_;  // guards what follows: one message at a time
  std::int32_t sec_ = 0;
  std::uint32_t nanosec_ = 0;
  std::vector<double> positions_;
  std::vector<std::uint8_t> is_known_, is_received_;  // has a position; is in the message
  std::vector<std::int64_t> published_ns_;            // stamp of the last message of each joint that was due; 0: none
  std::vector<std::string_view> names_;
  std::size_t known_count_ = 0;
  std::optional<std::size_t> left_out_;
};

}  // namespace tfloom::robot
