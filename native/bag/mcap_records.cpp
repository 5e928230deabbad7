#include "bag/mcap_records.hpp"

#include <algorithm>

namespace tfloom::bag {

RunSummary summarise(std::span<const std::byte> data, std::size_t begin) {
  RunSummary summary;
  RecordReader reader(data, begin);
  while (reader.advance()) {
    const Record& record = reader.record();
    if (reader.is_message()) {
      const MessageRecord message = reader.message();
      ++summary.counts[message.channel];
      summary.first = std::min(summary.first, message.log_time);
      summary.last = std::max(summary.last, message.log_time);
    } else if (record.opcode == static_cast<std::uint8_t>(Opcode::schema) ||
               record.opcode == static_cast<std::uint8_t>(Opcode::channel)) {
      summary.others.push_back(record);
    } else {
      reader.go_back();
      break;
    }
  }
  summary.end = reader.next();
  return summary;
}

IndexSummary summarise_indexes(std::span<const std::byte> data) {
  constexpr std::size_t prefix_size = 6;  // the channel, and the size of the entries
  constexpr std::size_t entry_size = 16;  // log time and offset
  IndexSummary summary;
  RecordReader reader(data, 0);
  while (reader.advance()) {
    const Record& record = reader.record();
    const std::size_t at = record.offset - record_header_size;
    if (record.opcode != static_cast<std::uint8_t>(Opcode::message_index)) {
      throw RecordError(at, "a record of kind " + std::to_string(record.opcode) + " is no message index");
    }
    const std::byte* content = data.data() + record.offset;
    if (record.size < prefix_size || (record.size - prefix_size) % entry_size != 0 ||
        read_little_endian<std::uint32_t>(content + 2) != record.size - prefix_size) {
      throw RecordError(at, "a message index of " + std::to_string(record.size) + " bytes has other entries");
    }
    for (const std::byte* entry = content + prefix_size; entry < content + record.size; entry += entry_size) {
      const auto log_time = read_little_endian<std::uint64_t>(entry);
      summary.first = std::min(summary.first, log_time);
      summary.last = std::max(summary.last, log_time);
      ++summary.count;
    }
  }
  reader.require_end();
  return summary;
}

}  // namespace tfloom::bag
