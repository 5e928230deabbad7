#include "dds/topic_type.hpp"

#include <cstring>
#include <optional>
#include <string>

#include "dds/canaried.hpp"
#include "dds/endpoint.hpp"
#include "dds/entity.hpp"
#include "dds/memory_probe.hpp"
#include "dds/qos.hpp"
#include "dds/silent_domain.hpp"

namespace tfloom::dds {
namespace {

constexpr const char* measured_type = "tfloom::msg::dds_::MeasuredType_";
constexpr const char* other_type = "tfloom::msg::dds_::OtherType_";
constexpr std::size_t max_topic_size = 4096;  // that of 0.10.2 is below 1 kB

// The beginning of the library's samples and types (0.10), as its headers declare them.
struct SampleHead {
  const void* functions;
  std::uint32_t hash;
  std::uint32_t reference_count;
  int kind;
  const Sertype_* type;
};

struct TypeHead {
  const void* functions;
  const void* sample_functions;
  std::uint32_t hash;
  std::uint32_t flags;
  std::uint32_t allowed_representations;
  const char* name;
};

bool is_type(const Sertype_* type, const char* name) {
  TypeHead head{};
  return copy_if_readable(type, &head, sizeof(head)) && is_text(head.name, name);
}

// A topic's memory, which stays where it is as long as this object exists.
class PinnedTopic {
 public:
  PinnedTopic(const Library& library, Entity topic) : library_(library) {
    library.check(library.entity_pin(topic, &memory_), "cannot get the type of a topic");
  }
  PinnedTopic(const PinnedTopic&) = delete;
  PinnedTopic& operator=(const PinnedTopic&) = delete;
  ~PinnedTopic() { library_.entity_unpin(memory_); }

  // Return the word at an offset, or nullopt if it can't be read.
  [[nodiscard]] std::optional<const Sertype_*> word(std::size_t offset) const {
    const Sertype_* word = nullptr;
    if (!copy_if_readable(static_cast<const std::byte*>(memory_) + offset, &word, sizeof(word))) return std::nullopt;
    return word;
  }

  [[nodiscard]] const Sertype_* type() const {
    const Sertype_* type = nullptr;
    std::memcpy(&type, static_cast<const std::byte*>(memory_) + library_.topic_type_offset, sizeof(type));
    return type;
  }

 private:
  const Library& library_;
  void* memory_ = nullptr;
};

// Write a sample by the function that needs no type, and return the type of what its reader receives.
const Sertype_* type_of_a_sample(const Library& l, const SilentDomain& domain, Entity topic) {
  const Qos qos;
  const OwnedEntity reader(
      l, l.create_reader(domain.participant(), topic, make_reader_qos(l, qos, "").get(), nullptr),
      "its reader can't be created");
  const OwnedEntity writer(
      l, l.create_writer(domain.participant(), topic, make_writer_qos(l, qos, "").get(), nullptr),
      "its writer can't be created");
  constexpr std::byte sample{};  // the one octet that the topic's descriptor declares
  l.check(l.write(writer.get(), &sample), "its writer can't write");
  Serdata_* serdata = nullptr;
  Canaried<SampleState> state;
  SampleHead head{};
  const Result count = l.readcdr(reader.get(), &serdata, 1, state.data(), 0);
  if (!state.is_intact_beyond()) throw Error("its sample info differs (dds_readcdr)");
  if (count != 1 || !copy_if_readable(serdata, &head, sizeof(head))) throw Error("its samples can't be read");
  l.serdata_unref(serdata);
  return head.type;
}

}  // namespace

const Sertype_* type_of(const Library& library, Entity topic, Entity writer) {
  if (library.get_entity_sertype == nullptr) return PinnedTopic(library, topic).type();
  const Sertype_* type = nullptr;
  library.check(library.get_entity_sertype(writer, &type), "cannot get the type of a topic");
  return type;
}

std::size_t measure_type_offset(const Library& library) {
  const SilentDomain domain(library, "");
  const OwnedEntity topic = create_topic(library, domain.participant(), {"rt/tfloom_measured", measured_type});
  const OwnedEntity other = create_topic(library, domain.participant(), {"rt/tfloom_other", other_type});
  const Sertype_* type = type_of_a_sample(library, domain, topic.get());
  if (!is_type(type, measured_type)) throw Error("its samples don't name their type");
  const PinnedTopic pinned(library, topic.get());
  const PinnedTopic other_pinned(library, other.get());
  // The first place is the topic's own: what holds the same pointer behind it, as a writer, is another object.
  for (std::size_t offset = 0; offset < max_topic_size; offset += sizeof(type)) {
    const auto word = pinned.word(offset);
    if (!word) break;
    if (*word != type) continue;
    if (is_type(other_pinned.word(offset).value_or(nullptr), other_type)) return offset;
    break;
  }
  throw Error("its topics don't show their type, and it has no dds_get_entity_sertype");
}

}  // namespace tfloom::dds
