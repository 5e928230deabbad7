#include "cdr/header_sink.hpp"

#include <exception>
#include <optional>

#include "cdr/cursor.hpp"
#include "cdr/tf_entries.hpp"
#include "core/utf8.hpp"

namespace tfloom::cdr {
namespace {

std::optional<std::string_view> read_frame_id(std::span<const std::byte> data) {
  try {
    Cursor in(data);
    read_stamp(in);
    const std::string_view name = in.read_string();
    if (name.size() <= HeaderSink::max_name_size && is_utf8(name)) return name;
  } catch (const DecodeError&) {  // reported as nullopt
  }
  return std::nullopt;
}

}  // namespace

void HeaderSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  try {
    const auto name = read_frame_id(data);
    const std::lock_guard lock(mutex_);
    if (name) {
      add({info.publisher_gid, *name});
    } else {
      ++unreadable_;
    }
  } catch (const std::exception&) {  // out of memory: the message is not counted
  }
}

void HeaderSink::add(const View& use) {
  const auto count = counts_.find(use);
  if (count != counts_.end()) {
    ++count->second;
  } else if (counts_.size() < max_uses) {
    counts_.emplace(Key(use.first, use.second), 1);
  }
}

std::vector<HeaderSink::Use> HeaderSink::uses() const {
  std::vector<Use> all;
  const std::lock_guard lock(mutex_);
  all.reserve(counts_.size());
  for (const auto& [key, count] : counts_) all.push_back({key.first, key.second, count});
  return all;
}

std::uint64_t HeaderSink::unreadable_count() const {
  const std::lock_guard lock(mutex_);
  return unreadable_;
}

}  // namespace tfloom::cdr
