// A sink of sensor_msgs/msg/JointState that hands the transforms on as tf2_msgs/msg/TFMessage.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/sink.hpp"
#include "robot/state_transforms.hpp"

namespace tfloom::robot {

// What comes of a message, and the bytes that are passed with it.
enum class OutputKind : unsigned char {
  transforms,   // a TFMessage
  refused,      // the message: it is unreadable, or its names and positions differ in number
  left_out,     // the name of a joint whose position is not finite
  moved_back,   // nothing: time is before that of the last message
};

class StateSink final : public Sink {
 public:
  using OutputFunction = std::function<void(OutputKind, std::vector<std::byte>)>;

  // Transforms are due after `interval_ns`; nullopt: always. See StateTransforms::convert. `emit` is called with no
  // lock held, within microseconds.
  StateSink(std::shared_ptr<StateTransforms> states, std::optional<std::int64_t> interval_ns, OutputFunction emit)
      : states_(std::move(states)), interval_ns_(interval_ns), emit_(std::move(emit)) {}

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  // Set the time of messages that are pushed from now on; nullopt: the one at which they are received.
  void set_simulated_time(std::optional<std::int64_t> now_ns) { simulated_ns_ = now_ns.value_or(no_time); }

 private:
  static constexpr std::int64_t no_time = INT64_MIN;

  void convert(std::span<const std::byte> data, std::int64_t now_ns);

  const std::shared_ptr<StateTransforms> states_;  // thread-safe by itself
  const std::optional<std::int64_t> interval_ns_;
  const OutputFunction emit_;
  std::atomic<std::int64_t> simulated_ns_ = no_time;
  std::atomic<std::int64_t> last_ns_ = no_time;  // written by `push` alone, which runs on one thread at a time
};

}  // namespace tfloom::robot
