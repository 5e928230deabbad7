// Decode tf2_msgs/msg/TFMessage directly into a buffer, without message objects.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cdr/ahead_filter.hpp"
#include "core/sink.hpp"
#include "tf2/buffer.hpp"

namespace tfloom::cdr {

// Append the message's transforms to `entries`; their names are views into `data`. Throw DecodeError if the bytes are
// not such a message. A name that is not UTF-8 is an error too, because a Python str cannot hold it.
void read_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries);

// Called for the first transform of a publisher that is held because it is stamped far ahead of now.
using HeldCallback = std::function<void(const Gid& publisher, const std::string& child_frame_id, tf2::Stamp stamp,
                                        tf2::Stamp now)>;

// A sink that stores the samples of /tf or /tf_static in a buffer. An unreadable message is dropped whole, because its
// readable part may be corrupt too; the buffer's log reports it. With
// `on_held`, moving transforms far ahead of now are held: see AheadFilter.
class TfSink final : public Sink {
 public:
  TfSink(std::shared_ptr<tf2::Buffer> buffer, std::string authority, bool is_static, HeldCallback on_held)
      : buffer_(std::move(buffer)),
        authority_(std::move(authority)),
        is_static_(is_static),
        on_held_(std::move(on_held)) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;
  void forget(const Gid& publisher) override;

  // Set the simulated time; 0: it has not been received, and nothing is held. nullopt: time is that of the system.
  void set_simulated_time(std::optional<tf2::Stamp> now);
  void forget_all();  // after a jump in time: what is held is dropped

  [[nodiscard]] std::uint64_t message_count() const { return messages_.load(); }  // all messages received
  [[nodiscard]] std::uint64_t dropped_count() const { return dropped_.load(); }   // those that were unreadable
  [[nodiscard]] std::size_t held_count() const;
  [[nodiscard]] std::size_t publisher_count() const;
  [[nodiscard]] const HeldCallback& on_held() const { return on_held_; }

 private:
  void insert(std::span<const std::byte> data, const SampleInfo& info);
  AheadFilter::Message filter(std::vector<tf2::Entry>& entries, const SampleInfo& info);

  const std::shared_ptr<tf2::Buffer> buffer_;  // thread-safe by itself
  const std::string authority_;
  const bool is_static_;
  const HeldCallback on_held_;  // called with no lock held
  mutable std::mutex mutex_;
  AheadFilter ahead_;                        // guarded by mutex_, like the next
  std::optional<tf2::Stamp> simulated_time_;
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace tfloom::cdr
