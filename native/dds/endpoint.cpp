#include "dds/endpoint.hpp"

namespace tfloom::dds {
namespace {

// The library's marshalling code for a type with one octet at offset 0 and nothing else.
constexpr std::uint32_t one_octet_ops[] = {0x01010000, 0, 0};
constexpr std::uint32_t restrict_representations = 1U << 7U;
constexpr std::uint32_t only_xcdr1 = 1;

}  // namespace

OwnedEntity create_topic(const Library& library, Entity participant, const TopicName& topic) {
  TopicDescriptor descriptor{};
  descriptor.size = 1;
  descriptor.alignment = 1;
  descriptor.flags = restrict_representations;
  descriptor.type_name = topic.type_name.c_str();
  descriptor.op_count = 3;
  descriptor.ops = one_octet_ops;
  descriptor.metadata = "";
  descriptor.allowed_representations = only_xcdr1;
  return {library, library.create_topic(participant, &descriptor, topic.name.c_str(), nullptr, nullptr),
          "cannot open topic " + topic.name};
}

}  // namespace tfloom::dds
