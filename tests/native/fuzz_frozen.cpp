// Fuzzes the reading of frozen buffers: a file is refused with a reason, or all that a buffer does with it is sound.
//
// An input: which fields of the header are mended, because few mutations would get past them; then the file. For the
// arguments, see fuzzing.hpp.
#include <cstring>
#include <memory>

#include "fuzzing.hpp"
#include "tf2/buffer.hpp"
#include "tf2/frozen.hpp"

namespace {

using namespace tfloom::tf2;

void mend(std::vector<std::byte>& data, std::uint8_t which) {
  FrozenHeader header;
  if (data.size() < sizeof header) return;
  std::memcpy(static_cast<void*>(&header), data.data(), sizeof header);
  if ((which & 1U) != 0) header.size = data.size();
  if ((which & 2U) != 0) {
    header.magic = FrozenHeader::expected_magic;
    header.order = FrozenHeader::expected_order;
    header.version = FrozenHeader::expected_version;
  }
  std::memcpy(data.data(), &header, sizeof header);
}

bool run(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return false;
  std::vector<std::byte> data(bytes.size() - 1);  // ends with its allocation, which is aligned to 16 bytes
  if (!data.empty()) std::memcpy(data.data(), bytes.data() + 1, data.size());
  mend(data, bytes[0]);
  Buffer buffer;
  try {
    buffer.map(data, nullptr);
  } catch (const FrozenError& error) {
    if (error.what()[0] == '\0') fuzzing::fail("fuzz_frozen", "an error has no text");
    return false;
  }
  const auto names = buffer.frame_names();
  for (std::size_t i = 0; i < names.size() && i < 16; ++i) {
    for (const Stamp stamp : {Stamp{0}, Stamp{5'000'000'000}, INT64_MAX}) {
      static_cast<void>(buffer.lookup(Query::at(names.front(), names[i], stamp)));
      static_cast<void>(buffer.check(Query::at(names[i], "map", stamp)));
    }
  }
  static_cast<void>(buffer.all_frames_as_yaml(0.0));
  static_cast<void>(buffer.edges());
  const auto again = buffer.freeze();
  Buffer mapped;
  mapped.map(again, nullptr);
  const Entry entry{"map", "base", 6'000'000'000, {}};
  mapped.set({&entry, 1}, "me", false);  // into a history that is a view
  return true;
}

}  // namespace

int main(int count, char** arguments) { return fuzzing::fuzz("fuzz_frozen", run, {{3}}, count, arguments); }
