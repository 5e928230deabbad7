// The format of a frozen buffer, which `Buffer::freeze` writes and `Buffer::map` reads in place.
//
// Version 1, in the byte order of the machine that wrote it; every part starts at a multiple of 8:
//
//     header    FrozenHeader
//     frames    FrozenFrame, one for each frame, in order of registration: the first has id 1
//     texts     each frame's name, then its authority, in the same order, UTF-8, without zeros between; padded
//     samples   of each moving frame that has some, in the same order: stamps (int64 each), values (seven float64
//               each: x y z, then x y z w), parents' ids (uint32 each); padded
//
// Padding is zeros. The samples are the last part.
//
// Inserting the same arrays takes 20 times as long, and 70 MB where mapping takes 1: benchmarks/native, "frozen file".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "tf2/frames.hpp"

namespace tfloom::tf2 {

struct FrozenHeader {
  static constexpr std::array<char, 8> expected_magic{'T', 'F', 'L', 'O', 'O', 'M', 'T', 'F'};
  static constexpr std::uint32_t expected_order = 0x01020304;
  static constexpr std::uint32_t expected_version = 1;

  std::array<char, 8> magic = expected_magic;
  std::uint32_t order = expected_order;  // has another value when read in the other byte order
  std::uint32_t version = expected_version;
  std::uint64_t size = 0;  // of everything [bytes]
  std::int64_t cache_time = 0;
  std::uint64_t frame_count = 0;
  std::uint64_t text_size = 0;  // without padding
};
static_assert(sizeof(FrozenHeader) == 48);

struct FrozenFrame {
  enum class Kind : std::uint32_t { root = 0, fixed = 1, moving = 2, removed = 3 };

  Kind kind = Kind::root;
  FrameId fixed_parent = no_parent;  // of a fixed frame, like the next
  Transform fixed_value{};
  std::uint64_t sample_count = 0;
  std::uint32_t name_size = 0, authority_size = 0;
};
static_assert(sizeof(FrozenFrame) == 80);

class FrozenError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FrozenContents {
  FrameTable frames{};
  Stamp cache_time = 0;
};

[[nodiscard]] std::vector<std::byte> freeze(const FrameTable& frames, Stamp cache_time);

// Check sizes, names, ids and that stamps ascend, but not the values of the samples. The histories are views of
// `frozen`. Throw FrozenError if a check fails.
[[nodiscard]] FrozenContents read_frozen(std::span<const std::byte> frozen);

}  // namespace tfloom::tf2
