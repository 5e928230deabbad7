#include "bag/mcap_records.hpp"

#include <algorithm>

namespace tfloom::bag {

RunSummary summarise(std::span<const std::byte> data, std::size_t begin) {
  RunSummary found;
  RecordWalk walk(data, begin);
  while (walk.advance()) {
    const Record& record = walk.record();
    if (walk.is_message()) {
      const MessageRecord message = walk.message();
      ++found.counts[message.channel];
      found.first = std::min(found.first, message.log_time);
      found.last = std::max(found.last, message.log_time);
    } else if (record.opcode == static_cast<std::uint8_t>(Opcode::schema) ||
               record.opcode == static_cast<std::uint8_t>(Opcode::channel)) {
      found.others.push_back(record);
    } else {
      walk.go_back();
      break;
    }
  }
  found.end = walk.next();
  return found;
}

}  // namespace tfloom::bag
