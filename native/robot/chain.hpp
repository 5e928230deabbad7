// Forward kinematics of a whole robot at many positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robot/joint.hpp"

namespace tfloom::robot {

// A joint of a chain. Links are counted in the order of the joints: joint i moves link i + 1, link 0 is the root.
struct ChainJoint {
  Joint joint;
  std::size_t parent_link = 0;  // at most the joint's own index, so that parents come first
  std::size_t variable = 0;     // column of its first variable
  // For a mimic joint: it stands at multiplier * variable + offset.
  double multiplier = 1.0, offset = 0.0;
};

class Chain {
 public:
  // Throw std::invalid_argument if a parent comes after its child, or a variable is out of range.
  Chain(std::vector<ChainJoint> joints, std::size_t variable_count);

  [[nodiscard]] std::size_t joint_count() const { return joints_.size(); }
  [[nodiscard]] std::size_t variable_count() const { return variable_count_; }

  // Fill `out`, one row for each joint, with parent_from_child. `at` has a number for each variable.
  void joint_poses(std::span<const double> at, std::span<tf2::Transform> out) const;
  // Fill `out`, one row for each link, with root_from_link. The first one is the identity.
  void link_poses(std::span<const double> at, std::span<tf2::Transform> out) const;

 private:
  [[nodiscard]] tf2::Transform pose(const ChainJoint& joint, std::span<const double> at) const;

  std::vector<ChainJoint> joints_;
  std::size_t variable_count_;
};

}  // namespace tfloom::robot
