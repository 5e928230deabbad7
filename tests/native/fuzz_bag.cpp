// Fuzzes the records of MCAP files and recorded transforms, in CDR and as ROS 1 writes them.
//
// An input: what it is; then the bytes of records, or of one message. For the arguments, see fuzzing.hpp.
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "bag/mcap_records.hpp"
#include "bag/tf_records.hpp"
#include "fuzzing.hpp"

namespace {

using namespace tfloom;

constexpr int inputs_per_buffer = 256;  // mutated names become frames, which a buffer never forgets
constexpr std::size_t head = 1;

struct Target {
  tf2::Buffer buffer{tf2::unlimited};
  bag::TfInserter moving{buffer, "moving", false, bag::Form::cdr};
  bag::TfInserter fixed{buffer, "fixed", true, bag::Form::cdr};
  bag::TfInserter ros1{buffer, "ros1", false, bag::Form::ros1};
  int inputs = 0;
};

// The walk and the summary must agree on the messages and on where they end.
bool walk(std::span<const std::byte> data, bag::TfInserter& inserter) {
  try {
    const bag::RunSummary summary = bag::summarise(data, 0);
    if (summary.end > data.size()) fuzzing::fail("fuzz_bag", "the summary ends behind the bytes");
    bag::RecordReader records(data.first(summary.end), 0);
    std::uint64_t messages = 0;
    while (records.advance()) {
      if (!records.is_message()) continue;
      const bag::MessageRecord message = records.message();
      ++messages;
      inserter.insert(data.subspan(message.offset, message.size));
    }
    inserter.finish();  // because the names of transforms are views into the bytes
    for (const auto& [channel, count] : summary.counts) messages -= count;
    if (messages != 0 || records.next() != summary.end) fuzzing::fail("fuzz_bag", "the walk and the summary differ");
    return summary.end == data.size() && !data.empty();
  } catch (const bag::RecordError& error) {
    inserter.finish();
    if (error.offset > data.size()) fuzzing::fail("fuzz_bag", "an error is placed behind the bytes");
    return false;
  }
}

bool run(std::span<const std::uint8_t> bytes) {
  static std::optional<Target> target;
  if (!target || target->inputs >= inputs_per_buffer) target.emplace();
  ++target->inputs;
  if (bytes.size() < head) return false;
  // A copy that ends with its allocation, so that the sanitizer sees one byte too many.
  std::vector<std::byte> data(bytes.size() - head);
  if (!data.empty()) std::memcpy(data.data(), bytes.data() + head, data.size());
  if (bytes[0] % 3 == 0) return walk(data, bytes[0] % 2 == 0 ? target->moving : target->fixed);
  bag::TfInserter& inserter = bytes[0] % 3 == 1 ? target->ros1 : target->moving;
  const auto dropped = inserter.dropped_count();
  inserter.insert(data);
  inserter.finish();
  return inserter.dropped_count() == dropped;
}

}  // namespace

int main(int count, char** arguments) { return fuzzing::fuzz("fuzz_bag", run, {{1, 0, 0, 0, 0}}, count, arguments); }
