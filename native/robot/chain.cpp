#include "robot/chain.hpp"

#include <stdexcept>
#include <utility>

namespace tfloom::robot {

Chain::Chain(std::vector<ChainJoint> joints, std::size_t variable_count)
    : joints_(std::move(joints)), variable_count_(variable_count) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& each = joints_[i];
    const std::size_t needed = robot::variable_count(each.joint.kind);
    if (each.parent_link > i) throw std::invalid_argument("a joint's parent link must come before its child link");
    if (needed > variable_count_ || each.variable > variable_count_ - needed) {
      throw std::invalid_argument("a joint's variables must be within those of the chain");
    }
  }
}

tf2::Transform Chain::pose(const ChainJoint& each, std::span<const double> at) const {
  const std::size_t count = robot::variable_count(each.joint.kind);
  if (count != 1) return each.joint.pose(at.subspan(each.variable, count));
  const double position = each.multiplier * at[each.variable] + each.offset;
  return each.joint.pose({&position, 1});
}

void Chain::joint_poses(std::span<const double> at, std::span<tf2::Transform> out) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) out[i] = pose(joints_[i], at);
}

void Chain::link_poses(std::span<const double> at, std::span<tf2::Transform> out) const {
  out[0] = {};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& each = joints_[i];
    out[i + 1] = out[each.parent_link] * pose(each, at);
    out[i + 1].rotation = tf2::canonical(out[i + 1].rotation);
  }
}

}  // namespace tfloom::robot
