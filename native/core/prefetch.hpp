// Load memory into the processor's cache before it is read.
#pragma once

#include <cstddef>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#endif

namespace tfloom {

// A hint only: any address is valid, and the results of the program do not depend on it. A cache line holds 64 bytes
// or more.
inline void prefetch(const void* address, std::size_t bytes = 1) {
  const char* const begin = static_cast<const char*>(address);
  for (std::size_t at = 0; at < bytes; at += 64) {
#if defined(__GNUC__) || defined(__clang__)
    __builtin_prefetch(begin + at);
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
    _mm_prefetch(begin + at, _MM_HINT_T0);
#else
    static_cast<void>(begin);
#endif
  }
}

}  // namespace tfloom
