#include "cdr/tf_message.hpp"

#include <exception>

#include "cdr/cursor.hpp"
#include "cdr/tf_entries.hpp"
#include "tf2/text.hpp"

namespace tfloom::cdr {
namespace {

constexpr std::size_t min_transform_size = 4 + 4 + 4 + 4 + 7 * 8;  // sec, nanosec, two string lengths, doubles
constexpr std::size_t max_padding = 7;  // wires pad to 4 or 8

}  // namespace

void read_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries) {
  Cursor in(data);
  read_transforms(in, min_transform_size, entries);
  if (in.left() > max_padding) in.fail(std::to_string(in.left()) + " bytes are left over");
}

void TfSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  messages_.fetch_add(1);
  try {
    insert(data, info);
  } catch (const std::exception&) {  // out of memory: counted, because a log text would need memory too
    dropped_.fetch_add(1);
  }
}

void TfSink::insert(std::span<const std::byte> data, const SampleInfo& info) {
  std::vector<tf2::Entry> entries;
  try {
    read_tf_message(data, entries);
  } catch (const DecodeError& error) {
    dropped_.fetch_add(1);
    buffer_->log().report(
        tf2::Severity::warn, "unreadable", authority_,
        tf2::join("dropped a message of ", std::to_string(data.size()), " bytes on ", is_static_ ? "/tf_static" : "/tf",
                  " that is no tf2_msgs/msg/TFMessage: ", error.text()));
    return;
  }
  // Without `on_held` nothing is held, because it could not be reported.
  const AheadFilter::Message message = is_static_ || !on_held_ ? AheadFilter::Message{} : filter(entries, info);
  if (!message.released.empty()) {
    std::vector<tf2::Entry> released;
    for (const auto& held : message.released) {
      released.push_back({held.frame_id, held.child_frame_id, held.stamp, held.value});
    }
    buffer_->set(released, authority_, is_static_);
  }
  buffer_->set(entries, authority_, is_static_);
  signal_push();
}

AheadFilter::Message TfSink::filter(std::vector<tf2::Entry>& entries, const SampleInfo& info) {
  AheadFilter::Message message;
  tf2::Stamp now = 0;
  {
    const std::lock_guard lock(mutex_);
    now = simulated_time_.value_or(info.received_stamp_ns);
    if (now != 0) message = ahead_.filter(entries, info.publisher_gid, now, buffer_->cache_time());
  }
  if (const auto& held = message.first_held; held) {
    on_held_(info.publisher_gid, held->child_frame_id, held->stamp, now);
  }
  return message;
}

void TfSink::forget(const Gid& publisher) {
  const std::lock_guard lock(mutex_);
  ahead_.forget(publisher);
}

void TfSink::forget_all() {
  const std::lock_guard lock(mutex_);
  ahead_.clear();
}

void TfSink::set_simulated_time(std::optional<tf2::Stamp> now) {
  const std::lock_guard lock(mutex_);
  simulated_time_ = now;
}

std::size_t TfSink::held_count() const {
  const std::lock_guard lock(mutex_);
  return ahead_.held_count();
}

std::size_t TfSink::publisher_count() const {
  const std::lock_guard lock(mutex_);
  return ahead_.publisher_count();
}

}  // namespace tfloom::cdr
