// What a reader and a writer share: a topic of raw CDR under ROS's names.
#pragma once

#include <string>

#include "dds/entity.hpp"
#include "dds/participant.hpp"

namespace tfloom::dds {

// A topic by its names on the wire, `rt/turtle1/pose` and `turtlesim::msg::dds_::Pose_`.
struct TopicName {
  std::string name;
  std::string type_name;
};

// Create a topic whose samples pass unchanged. Its type descriptor declares one octet, so the library checks only that
// a sample has at least one. It carries no type information, so other vendors compare type names alone.
OwnedEntity create_topic(const Library& library, Entity participant, const TopicName& topic);

}  // namespace tfloom::dds
