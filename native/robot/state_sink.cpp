#include "robot/state_sink.hpp"

#include <exception>

#include "cdr/cursor.hpp"

namespace tfloom::robot {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

}  // namespace

void StateSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  const std::int64_t simulated_ns = simulated_ns_;
  try {
    convert(data, simulated_ns == no_time ? info.received_stamp_ns : simulated_ns);
  } catch (const std::exception&) {  // out of memory: the message is lost, as best effort allows
  }
  signal_push();
}

void StateSink::convert(std::span<const std::byte> data, std::int64_t now_ns) {
  if (now_ns < last_ns_.exchange(now_ns)) {
    states_->forget_stamps();
    emit_(OutputKind::moved_back, {});
  }
  std::vector<std::byte> message;
  try {
    message = states_->convert(data, now_ns, interval_ns_);
  } catch (const cdr::DecodeError&) {
    emit_(OutputKind::refused, {data.begin(), data.end()});
    return;
  }
  if (const std::string name = states_->left_out(); !name.empty()) emit_(OutputKind::left_out, bytes_of(name));
  if (!message.empty()) emit_(OutputKind::transforms, std::move(message));
}

}  // namespace tfloom::robot
