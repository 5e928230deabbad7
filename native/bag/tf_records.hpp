// Transforms of recorded messages, stored in a buffer without message objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tf2/buffer.hpp"

namespace tfloom::bag {

// How the messages of a topic are serialized: as CDR with its header, or as ROS 1 does.
enum class Form : std::uint8_t { cdr, ros1 };

// Append the transforms of a ROS 1 message `tf2_msgs/TFMessage` or `tf/tfMessage`, which have the same bytes, to
// `entries`; their names are views into `data`. Throw cdr::DecodeError if the bytes are not such a message.
void read_ros1_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries);

// Stores messages of one topic. Transforms of several messages are inserted under one lock, so the last ones are stored
// by `finish`; the bytes of all messages must be valid until then.
class TfInserter {
 public:
  TfInserter(tf2::Buffer& buffer, std::string authority, bool is_static, Form form)
      : buffer_(&buffer), authority_(std::move(authority)), is_static_(is_static), form_(form) {}

  void insert(std::span<const std::byte> message);
  void finish();

  [[nodiscard]] bool is_static() const { return is_static_; }
  [[nodiscard]] std::uint64_t message_count() const { return messages_; }
  [[nodiscard]] std::uint64_t dropped_count() const { return dropped_; }  // unreadable ones, which the log has reported

 private:
  tf2::Buffer* buffer_;
  std::string authority_;
  bool is_static_;
  Form form_;
  std::vector<tf2::Entry> entries_;
  std::uint64_t messages_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace tfloom::bag
