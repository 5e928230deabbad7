// Decode tf2_msgs/msg/TFMessage directly into a buffer, without message objects.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/sink.hpp"
#include "tf2/buffer.hpp"

namespace tfloom::cdr {

// Append the message's transforms to `entries`; their names are views into `data`. Throw DecodeError if the bytes are
// not such a message. A name that is not UTF-8 is an error too, because a Python str cannot hold it.
void read_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries);

// A sink that stores the samples of /tf or /tf_static in a buffer. An unreadable message is dropped whole, because its
// readable part may be corrupt too; the buffer's log reports it.
class TfSink final : public Sink {
 public:
  TfSink(std::shared_ptr<tf2::Buffer> buffer, std::string authority, bool is_static)
      : buffer_(std::move(buffer)), authority_(std::move(authority)), is_static_(is_static) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  [[nodiscard]] std::uint64_t message_count() const { return messages_.load(); }  // all messages received
  [[nodiscard]] std::uint64_t dropped_count() const { return dropped_.load(); }   // those that were unreadable

 private:
  void insert(std::span<const std::byte> data);

  const std::shared_ptr<tf2::Buffer> buffer_;  // thread-safe by itself
  const std::string authority_;
  const bool is_static_;
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace tfloom::cdr
