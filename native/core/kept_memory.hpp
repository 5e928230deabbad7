// Memory of large messages, which the process keeps for the next ones.
#pragma once

#include <cstddef>
#ifdef __GLIBC__
#include <malloc.h>
#include <unistd.h>

#include <string_view>
#endif

namespace tfloom {

// From here on, glibc gives the memory of each message back to the system, so the next one faults on each of its pages.
constexpr std::size_t min_kept_memory = 128 << 10;  // glibc's own M_MMAP_THRESHOLD [bytes]

#ifdef __GLIBC__
namespace detail {

// Return whether the environment sets how the process allocates.
inline bool is_allocation_set() {
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    if (text.starts_with("MALLOC_") || text.starts_with("GLIBC_TUNABLES=")) return true;
  }
  return false;
}

// Return whether the process keeps memory from here on.
inline bool keep_memory() {
  constexpr int most_from_heap = 32 << 20;  // the greatest that glibc permits
  constexpr int most_kept = 64 << 20;       // at the end of each arena
  return !is_allocation_set() && mallopt(M_MMAP_THRESHOLD, most_from_heap) == 1 &&
         mallopt(M_TRIM_THRESHOLD, most_kept) == 1;
}

}  // namespace detail
#endif

// Let the process keep what it frees, from the first message of `min_kept_memory` on, unless its environment sets how it
// allocates. To be called with the GIL held, because Python changes the environment.
//
// A pool of our own would serve the vectors of this library alone: most of the copies of a message belong to libddsc and to
// Python's objects, which allocate for themselves. If nothing is kept, decoding 8 MB while the program holds others takes
// several times as long: benchmarks/native, "kept memory".
inline void keep_memory_of(std::size_t message_size) {
#ifdef __GLIBC__
  if (message_size < min_kept_memory) return;
  static const bool is_kept = detail::keep_memory();
  static_cast<void>(is_kept);
#else
  static_cast<void>(message_size);
#endif
}

}  // namespace tfloom
