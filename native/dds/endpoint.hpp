// What a reader and a writer have in common: a topic of raw CDR in its ROS dress.
#pragma once

#include <string>

#include "dds/participant.hpp"

namespace tfloom::dds {

// A topic by its names on the wire, `rt/turtle1/pose` and `turtlesim::msg::dds_::Pose_`.
struct TopicName {
  std::string name;
  std::string type_name;
};

// Opens a topic whose samples pass as they are. The type that the library is told has one octet, so it checks that
// there is one and looks no further; no type information goes out, so other vendors compare type names alone.
Entity create_topic(Participant& participant, const TopicName& topic);

}  // namespace tfloom::dds
