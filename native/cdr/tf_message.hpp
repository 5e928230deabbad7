// tf2_msgs/msg/TFMessage: its bytes straight into a buffer, with no message in between.
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

// Appends the message's transforms to `entries`; their names are views into `data`. Throws DecodeError where the
// bytes are no such message: a name that is not UTF-8 is an error too, as Python could not hold it.
void read_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries);

// Takes the samples of /tf or /tf_static. A message that can't be read is dropped whole, as nobody can tell which
// part of it is sound; the buffer's log says so.
class TfSink final : public Sink {
 public:
  TfSink(std::shared_ptr<tf2::Buffer> buffer, std::string authority, bool is_static)
      : buffer_(std::move(buffer)), authority_(std::move(authority)), is_static_(is_static) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  [[nodiscard]] std::uint64_t message_count() const { return messages_.load(); }  // all that came
  [[nodiscard]] std::uint64_t dropped_count() const { return dropped_.load(); }   // of these, unreadable

 private:
  void insert(std::span<const std::byte> data);

  const std::shared_ptr<tf2::Buffer> buffer_;
  const std::string authority_;
  const bool is_static_;
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace tfloom::cdr
