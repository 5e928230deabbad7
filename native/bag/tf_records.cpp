#include "bag/tf_records.hpp"

#include <bit>

#include "bag/mcap_records.hpp"
#include "cdr/cursor.hpp"
#include "cdr/tf_entries.hpp"
#include "cdr/tf_message.hpp"
#include "tf2/text.hpp"

namespace tfloom::bag {
namespace {

constexpr std::size_t max_entries = 512;  // that are stored under one lock
constexpr std::size_t min_ros1_size = 4 + 8 + 4 + 4 + 7 * 8;

// ROS 1 bytes: little-endian, packed, without a header; a string has no terminating zero.
class Ros1Cursor {
 public:
  explicit Ros1Cursor(std::span<const std::byte> data) : data_(data) {}

  [[nodiscard]] std::size_t left() const { return data_.size() - at_; }

  std::uint32_t read_uint32() { return read_little_endian<std::uint32_t>(take(4)); }

  std::uint32_t read_length(std::size_t min_element_size) {
    const std::uint32_t length = read_uint32();
    if (length * std::uint64_t{min_element_size} > left()) {
      fail("the length " + std::to_string(length) + " is more than the " + std::to_string(left()) +
           " bytes left can hold");
    }
    return length;
  }

  std::string_view read_string() {
    const std::size_t length = read_length(1);
    return {reinterpret_cast<const char*>(take(length)), length};
  }

  void read_into(std::span<double> out) {
    const std::byte* from = take(out.size_bytes());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = std::bit_cast<double>(read_little_endian<std::uint64_t>(from + i * sizeof(double)));
    }
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

tf2::Stamp read_stamp(Ros1Cursor& in) {
  in.read_uint32();  // the sequence number
  const std::int64_t sec = in.read_uint32();
  return sec * cdr::ns_per_s + in.read_uint32();
}

}  // namespace

void read_ros1_tf_message(std::span<const std::byte> data, std::vector<tf2::Entry>& entries) {
  Ros1Cursor in(data);
  cdr::read_transforms(in, min_ros1_size, entries);
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
                  " that is no TFMessage: ", error.text()));
  }
  if (entries_.size() >= max_entries) finish();
}

void TfInserter::finish() {
  if (!entries_.empty()) buffer_->set(entries_, authority_, is_static_);
  entries_.clear();
}

}  // namespace tfloom::bag
