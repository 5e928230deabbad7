#include "bag/tf_records.hpp"

#include <array>
#include <bit>

#include "bag/mcap_records.hpp"
#include "cdr/cursor.hpp"
#include "cdr/tf_message.hpp"
#include "core/utf8.hpp"
#include "tf2/text.hpp"

namespace tfloom::bag {
namespace {

constexpr std::size_t most_entries = 512;  // that are stored under one lock
constexpr std::size_t least_ros1_size = 4 + 8 + 4 + 4 + 7 * 8;
constexpr std::int64_t ns_per_s = 1'000'000'000;

// ROS 1 bytes: little-endian, packed, without a header; a string has no terminating zero.
class Ros1Cursor {
 public:
  explicit Ros1Cursor(std::span<const std::byte> data) : data_(data) {}

  [[nodiscard]] std::size_t left() const { return data_.size() - at_; }

  std::uint32_t read_uint32() { return read_little_endian<std::uint32_t>(take(4)); }
  double read_double() { return std::bit_cast<double>(read_little_endian<std::uint64_t>(take(8))); }

  std::string_view read_string() {
    const std::size_t length = read_uint32();
    const std::string_view text(reinterpret_cast<const char*>(take(length)), length);
    if (!is_utf8(text)) fail("the text is not UTF-8");
    return text;
  }

  [[noreturn]] void fail(const std::string& reason) const { throw cdr::DecodeError(at_, reason); }

 private:
  const std::byte* take(std::size_t count) {
    if (count > left()) {
      fail(std::to_string(count) + " bytes are needed, " + std::to_string(left()) + " are left");
    }
    const std::byte* from = data_.data() + at_;
    at_ += count;
    return from;
  }

  std::span<const std::byte> data_;
  std::size_t at_ = 0;
};

tf2::Entry read_ros1_transform(Ros1Cursor& in) {
  tf2::Entry entry;
  in.read_uint32();  // the sequence number
  const std::int64_t sec = in.read_uint32();
  entry.stamp = sec * ns_per_s + in.read_uint32();
  entry.frame_id = in.read_string();
  entry.child_frame_id = in.read_string();
  std::array<double, 7> numbers{};
  for (double& number : numbers) number = in.read_double();
  const auto& [x, y, z, qx, qy, qz, qw] = numbers;
  entry.value = {{x, y, z}, {qx, qy, qz, qw}};
  return entry;
}

}  // namespace

void read_ros1_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries) {
  Ros1Cursor in(data);
  const std::uint32_t count = in.read_uint32();
  if (count * std::uint64_t{least_ros1_size} > in.left()) {
    in.fail("the length " + std::to_string(count) + " is more than the bytes left can hold");
  }
  for (std::uint32_t i = 0; i < count; ++i) entries.push_back(read_ros1_transform(in));
  if (in.left() != 0) in.fail(std::to_string(in.left()) + " bytes are left over");
}

void TfInserter::insert(std::span<const std::byte> message) {
  ++messages_;
  const std::size_t before = entries_.size();
  try {
    form_ == Form::cdr ? cdr::read_tf_message(message, entries_) : read_ros1_tf_message(message, entries_);
  } catch (const cdr::DecodeError& error) {
    entries_.resize(before);
    ++dropped_;
    buffer_->log().report(
        tf2::Severity::warn, "unreadable", authority_,
        tf2::join("dropped a recorded message of ", std::to_string(message.size()), " bytes on ", authority_,
                  " that is no TFMessage: ", error.path, error.path.empty() ? "" : ": ", error.what(), " (at byte ",
                  std::to_string(error.offset), ")"));
  }
  if (entries_.size() >= most_entries) finish();
}

void TfInserter::finish() {
  if (!entries_.empty()) buffer_->set(entries_, authority_, is_static_);
  entries_.clear();
}

}  // namespace tfloom::bag
