// The records of an MCAP file, in bytes that may be hostile: each length is checked against the bytes that are left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tfloom::bag {

// A record that does not fit into the bytes around it, or a message record that is too short.
class RecordError : public std::runtime_error {
 public:
  RecordError(std::size_t at, const std::string& reason) : std::runtime_error(reason), offset(at) {}

  std::size_t offset;  // of the record, in the bytes
};

enum class Opcode : std::uint8_t { schema = 3, channel = 4, message = 5, message_index = 7 };

// The content of a record, without its opcode and its length.
struct Record {
  std::uint8_t opcode = 0;
  std::size_t offset = 0;
  std::size_t size = 0;
};

struct MessageRecord {
  std::uint16_t channel = 0;
  std::uint64_t log_time = 0;      // [ns since epoch]
  std::uint64_t publish_time = 0;  // [ns since epoch]
  std::size_t offset = 0;          // of the message's own bytes
  std::size_t size = 0;
};

inline constexpr std::size_t record_header_size = 9;
inline constexpr std::size_t message_header_size = 22;

template <class T>
T read_little_endian(const std::byte* from) {
  T value{};
  for (std::size_t i = sizeof(T); i-- > 0;) value = static_cast<T>(value << 8 | std::to_integer<T>(from[i]));
  return value;
}

// Reads records one after the other.
class RecordReader {
 public:
  RecordReader(std::span<const std::byte> data, std::size_t begin) : data_(data), next_(begin) {}

  // Read the next record; return false at the end, or before a record that is not whole.
  bool advance() {
    if (next_ > data_.size() || data_.size() - next_ < record_header_size) return false;
    const std::byte* header = data_.data() + next_;
    const auto size = read_little_endian<std::uint64_t>(header + 1);
    if (size > data_.size() - next_ - record_header_size) return false;
    record_ = {std::to_integer<std::uint8_t>(header[0]), next_ + record_header_size, static_cast<std::size_t>(size)};
    next_ = record_.offset + record_.size;
    return true;
  }

  [[nodiscard]] const Record& record() const { return record_; }
  [[nodiscard]] bool is_message() const { return record_.opcode == static_cast<std::uint8_t>(Opcode::message); }
  [[nodiscard]] std::size_t next() const { return next_; }  // where the next record begins
  void go_back() { next_ = record_.offset - record_header_size; }  // to the record that was read

  // Throw RecordError if the record is too short for a message.
  [[nodiscard]] MessageRecord message() const {
    if (record_.size < message_header_size) {
      throw RecordError(record_.offset - record_header_size,
                        "a message record has 22 bytes or more, not " + std::to_string(record_.size));
    }
    const std::byte* from = data_.data() + record_.offset;
    return {read_little_endian<std::uint16_t>(from), read_little_endian<std::uint64_t>(from + 6),
            read_little_endian<std::uint64_t>(from + 14), record_.offset + message_header_size,
            record_.size - message_header_size};
  }

  // Throw RecordError unless all bytes were read.
  void require_end() const {
    if (next_ == data_.size()) return;
    throw RecordError(next_, "the record does not fit into the " + std::to_string(data_.size() - next_) + " bytes left");
  }

 private:
  std::span<const std::byte> data_;
  std::size_t next_;
  Record record_;
};

// What a run of records holds.
struct RunSummary {
  std::map<std::uint16_t, std::uint64_t> counts;  // messages of each channel
  std::uint64_t first = UINT64_MAX, last = 0;     // log times of the messages
  std::vector<Record> others;                     // schemas and channels
  std::size_t end = 0;                            // where the first record begins that is of another kind, or not whole
};

RunSummary summarise(std::span<const std::byte> data, std::size_t begin);

// What message index records state about the messages of a chunk.
struct IndexSummary {
  std::uint64_t count = 0;
  std::uint64_t first = UINT64_MAX, last = 0;  // log times
};

// Throw RecordError if a record isn't a message index, or isn't whole.
IndexSummary summarise_indexes(std::span<const std::byte> data);

}  // namespace tfloom::bag
