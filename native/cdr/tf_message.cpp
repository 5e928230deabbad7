#include "cdr/tf_message.hpp"

#include "cdr/cursor.hpp"
#include "core/utf8.hpp"
#include "tf2/text.hpp"

namespace tfloom::cdr {
namespace {

constexpr std::size_t least_transform_size = 4 + 4 + 4 + 4 + 7 * 8;  // sec, nanosec, two string lengths, doubles
constexpr std::size_t most_padding = 7;  // wires pad to 4 or 8
constexpr std::int64_t ns_per_s = 1'000'000'000;

std::string_view read_name(Cursor& in, std::string_view field) {
  try {
    const std::string_view name = in.read_string();
    if (!is_utf8(name)) in.fail("the text is not UTF-8");
    return name;
  } catch (DecodeError& error) {
    error.enter_field(field);
    throw;
  }
}

tf2::Entry read_transform(Cursor& in) {
  tf2::Entry entry;
  const auto sec = in.read<std::int32_t>();
  const auto nanosec = in.read<std::uint32_t>();
  entry.stamp = sec * ns_per_s + nanosec;
  entry.frame_id = read_name(in, "header.frame_id");
  entry.child_frame_id = read_name(in, "child_frame_id");
  double numbers[7];
  in.read_into(std::span<double>(numbers));
  const auto& [x, y, z, qx, qy, qz, qw] = numbers;
  entry.value = {{x, y, z}, {qx, qy, qz, qw}};
  return entry;
}

}  // namespace

void read_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries) {
  Cursor in(data);
  const std::uint32_t count = in.read_length(least_transform_size);
  entries.reserve(entries.size() + count);
  for (std::uint32_t i = 0; i < count; ++i) {
    try {
      entries.push_back(read_transform(in));
    } catch (DecodeError& error) {
      error.enter_element(i);
      error.enter_field("transforms");
      throw;
    }
  }
  if (in.left() > most_padding) in.fail(std::to_string(in.left()) + " bytes are left over");
}

void TfSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  messages_.fetch_add(1);
  try {
    insert(data, info);
  } catch (...) {  // out of memory: counted, because a log text would need memory too
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
                  " that is no tf2_msgs/msg/TFMessage: ", error.path, error.path.empty() ? "" : ": ", error.what(),
                  " (at byte ", std::to_string(error.offset), ")"));
    return;
  }
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
