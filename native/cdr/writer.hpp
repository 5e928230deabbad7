// A writer of CDR, always little-endian and version 1: encapsulation header, alignment, growing storage.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include "cdr/cursor.hpp"

namespace tfloom::cdr {

// Storage has `std::span<std::byte> resize(std::size_t)`, which keeps the contents and may move them. If it has
// `min_referred`, numbers of at least that many bytes are not copied: `void refer(std::size_t offset, std::span<const
// std::byte>)` is called with them, and with the number of bytes of the storage that come before them.
template <class Storage>
class Writer {
 public:
  Writer(Storage& storage, std::size_t size_hint) : storage_(storage) {
    memory_ = storage_.resize(std::max(size_hint, Cursor::header_size));
    std::memcpy(memory_.data(), "\x00\x01\x00\x00", Cursor::header_size);  // CDR_LE, no options
    at_ = Cursor::header_size;
  }

  // The size of all that was written, and of that in the storage [bytes].
  [[nodiscard]] std::size_t size() const noexcept { return at_; }
  [[nodiscard]] std::size_t stored_size() const noexcept { return at_ - referred_; }

  template <Number T>
  void write(T value) {
    if constexpr (std::endian::native == std::endian::big) value = detail::swap_bytes(value);
    std::memcpy(reserve(sizeof(T), sizeof(T)), &value, sizeof(T));
  }

  // Write numbers in host byte order, contiguous and not necessarily aligned in memory. Write nothing if there are
  // none.
  template <Number T>
  void write_all(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    if constexpr (requires { Storage::min_referred; }) {
      const bool is_as_written = std::endian::native == std::endian::little || sizeof(T) == 1;
      if (is_as_written && bytes.size() >= Storage::min_referred) {
        reserve(sizeof(T), 0);  // the gap
        storage_.refer(stored_size(), bytes);
        at_ += bytes.size();
        referred_ += bytes.size();
        return;
      }
    }
    std::byte* to = reserve(sizeof(T), bytes.size());
    std::memcpy(to, bytes.data(), bytes.size());
    if constexpr (std::endian::native == std::endian::big && sizeof(T) > 1) {
      for (std::size_t i = 0; i < bytes.size(); i += sizeof(T)) std::reverse(to + i, to + i + sizeof(T));
    }
  }

  void write_string(std::string_view text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    std::byte* to = reserve(1, text.size() + 1);
    std::memcpy(to, text.data(), text.size());
    to[text.size()] = std::byte{0};
  }

 private:
  std::byte* reserve(std::size_t alignment, std::size_t count) {
    const std::size_t gap = (Cursor::header_size - at_) & (alignment - 1);
    if (memory_.size() - stored_size() < gap + count) grow(gap + count);
    std::byte* to = memory_.data() + stored_size();
    for (std::size_t i = 0; i < gap; ++i) to[i] = std::byte{0};
    at_ += gap + count;
    return to + gap;
  }

  // The spare memory is limited, so that writing an image does not double its memory.
  void grow(std::size_t count) {
    const std::size_t spare = std::min<std::size_t>(stored_size(), 65536) + 64;
    memory_ = storage_.resize(stored_size() + count + spare);
  }

  Storage& storage_;
  std::span<std::byte> memory_;
  std::size_t at_ = 0;        // in what is written
  std::size_t referred_ = 0;  // of it, outside the storage
};

}  // namespace tfloom::cdr
