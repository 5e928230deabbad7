#include "robot/chain.hpp"

#include <stdexcept>
#include <utility>

namespace tfloom::robot {

Chain::Chain(std::vector<ChainJoint> joints, std::size_t variable_count)
    : joints_(std::move(joints)), variable_count_(variable_count) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& joint = joints_[i];
    const std::size_t needed = robot::variable_count(joint.joint.kind);
    if (joint.parent_link > i) throw std::invalid_argument("a joint's parent link must come before its child link");
    if (needed > variable_count_ || joint.variable > variable_count_ - needed) {
      throw std::invalid_argument("a joint's variables must be within those of the chain");
    }
  }
}

tf2::Transform Chain::pose(const ChainJoint& joint, std::span<const double> at) const {
  const std::size_t count = robot::variable_count(joint.joint.kind);
  if (count != 1) return joint.joint.pose(at.subspan(joint.variable, count));
  const double position = joint.multiplier * at[joint.variable] + joint.offset;
  return joint.joint.pose({&position, 1});
}

void Chain::joint_poses(std::span<const double> at, std::span<tf2::Transform> out) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) out[i] = pose(joints_[i], at);
}

void Chain::link_poses(std::span<const double> at, std::span<tf2::Transform> out) const {
  out[0] = {};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& joint = joints_[i];
    out[i + 1] = out[joint.parent_link] * pose(joint, at);
    out[i + 1].rotation = tf2::canonical(out[i + 1].rotation);
  }
}

}  // namespace tfloom::robot
