#include "core/vector_width.hpp"

#include <atomic>

namespace tfloom {
namespace {

bool has_wide_vectors() {
#ifdef TFLOOM_WIDE_TARGET
  __builtin_cpu_init();  // this may run before the constructors of the compiler's runtime
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

std::atomic<bool> is_wide = has_wide_vectors();

}  // namespace

bool vectors_are_wide() { return is_wide.load(std::memory_order_relaxed); }

bool use_wide_vectors(bool are_wide) { return is_wide = are_wide && has_wide_vectors(); }

}  // namespace tfloom
