// A reader of untrusted CDR bytes: each read is checked against the bytes that are left.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace tfloom::cdr {

static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);

// Numbers of fixed size, as in CDR. A bool is read as std::uint8_t.
template <class T>
concept Number = std::is_arithmetic_v<T> && !std::same_as<T, bool> && sizeof(T) <= 8;

// An error inside a message. `path` grows from the inside out while the error unwinds:
// "transforms[3].transform.translation.x".
class PathError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  void enter_field(std::string_view name) { path = std::string(name) + separator() + path; }
  void enter_element(std::size_t index) { path = '[' + std::to_string(index) + ']' + separator() + path; }

  std::string path;

 private:
  [[nodiscard]] const char* separator() const noexcept { return path.empty() || path.front() == '[' ? "" : "."; }
};

// Bytes that are not a sample of the type. `offset` counts from the first octet of the encapsulation header.
class DecodeError : public PathError {
 public:
  DecodeError(std::size_t at, const std::string& reason) : PathError(reason), offset(at) {}

  // The field, the reason and the place, for a log.
  [[nodiscard]] std::string text() const {
    return (path.empty() ? path : path + ": ") + what() + " (at byte " + std::to_string(offset) + ")";
  }

  std::size_t offset;
};

namespace detail {

template <Number T>
T swap_bytes(T value) noexcept {
  std::byte bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

}  // namespace detail

// Plain CDR, version 1 (XCDR1): a number of n bytes is aligned to n bytes, counted from the end of the encapsulation
// header.
class Cursor {
 public:
  static constexpr std::size_t header_size = 4;

  // Read the encapsulation header. `data` must outlive the cursor and all views that it returns.
  explicit Cursor(std::span<const std::byte> data) : begin_(data.data()), size_(data.size()) {
    if (size_ < header_size) fail("a sample has a header of 4 bytes, this one ends after " + std::to_string(size_));
    const auto kind = std::to_integer<unsigned>(data[0]) << 8 | std::to_integer<unsigned>(data[1]);
    if (kind > 1) fail("representation " + std::to_string(kind) + " is neither CDR_BE (0) nor CDR_LE (1)");
    swap_ = (kind == 1) != (std::endian::native == std::endian::little);
    at_ = header_size;
  }

  [[nodiscard]] std::size_t offset() const noexcept { return at_; }  // from the start of the header
  [[nodiscard]] std::size_t left() const noexcept { return size_ - at_; }
  [[nodiscard]] bool swaps() const noexcept { return swap_; }  // whether the sample has the other byte order

  template <Number T>
  T read() {
    T value;
    std::memcpy(&value, take(sizeof(T), sizeof(T)), sizeof(T));
    return swap_ ? detail::swap_bytes(value) : value;
  }

  // Fill `out`. If it is empty, the position does not change, not even for alignment.
  template <Number T>
  void read_into(std::span<T> out) {
    if (out.empty()) return;
    const std::byte* from = take(sizeof(T), out.size_bytes());
    std::memcpy(out.data(), from, out.size_bytes());
    if (swap_ && sizeof(T) > 1) std::ranges::transform(out, out.begin(), detail::swap_bytes<T>);
  }

  // Return the bytes of `count` numbers of `size` bytes, in the sample's byte order. If `count` is 0, the position
  // does not change.
  std::span<const std::byte> read_bytes(std::uint32_t count, std::size_t size) {
    if (count == 0) return {};
    return {take(size, count * size), count * size};
  }

  // Read the length of a sequence whose elements take `min_element_size` bytes or more each. A length that does not
  // fit into the bytes left is an error here, so that callers can allocate for it.
  std::uint32_t read_length(std::size_t min_element_size) {
    const auto length = read<std::uint32_t>();
    if (length * std::uint64_t{min_element_size} > left()) fail_length(length);
    return length;
  }

  // Check that `count` elements of `min_element_size` bytes or more fit into the bytes left.
  void require(std::uint32_t count, std::size_t min_element_size) const {
    if (count * std::uint64_t{min_element_size} > left()) fail_short(at_, count * min_element_size);
  }

  // Return a view that ends before the terminating zero. It is not checked for UTF-8. A length of 0, which some writers
  // send for the empty string, is the empty string.
  std::string_view read_string() {
    const auto length = read_length(1);
    if (length == 0) return {};
    const auto* from = reinterpret_cast<const char*>(take(1, length));
    if (from[length - 1] != '\0') {
      at_ -= 1;
      fail("the string does not end with a zero byte");
    }
    return {from, length - 1};
  }

  [[noreturn]] void fail(const std::string& reason) const { throw DecodeError(at_, reason); }

 private:
  [[nodiscard]] std::size_t aligned(std::size_t alignment) const noexcept {
    return header_size + ((at_ - header_size + alignment - 1) & ~(alignment - 1));
  }

  const std::byte* take(std::size_t alignment, std::size_t count) {
    const std::size_t start = aligned(alignment);
    if (start > size_ || count > size_ - start) fail_short(start, count);
    at_ = start + count;
    return begin_ + start;
  }

  [[noreturn]] void fail_short(std::size_t start, std::size_t count) const {
    fail(std::to_string(count) + " bytes are needed, " + std::to_string(start < size_ ? size_ - start : 0) +
         " are left");
  }
  [[noreturn]] void fail_length(std::uint32_t length) {
    at_ -= sizeof(length);
    fail("the length " + std::to_string(length) + " is more than the " +
         std::to_string(left() - sizeof(length)) + " bytes left can hold");
  }

  const std::byte* begin_;
  std::size_t size_;
  std::size_t at_ = 0;
  bool swap_ = false;
};

}  // namespace tfloom::cdr
