#include "core/time_slice.hpp"

#ifdef __linux__
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace tfloom {

#if defined(__linux__) && defined(SYS_sched_getattr) && defined(SYS_sched_setattr)
namespace {

constexpr std::uint64_t slice_ns = 100'000;  // the shortest that Linux accepts

// The first version of the structure of sched_setattr(2), for which C libraries before glibc 2.41 have no declaration.
struct Attributes {
  std::uint32_t size;
  std::uint32_t policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime;  // of a thread of the usual policy: its slice [ns]
  std::uint64_t deadline;
  std::uint64_t period;
};
static_assert(sizeof(Attributes) == 48);

}  // namespace

void use_short_slice() noexcept {
  Attributes attributes{};
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0U) != 0) return;
  if (attributes.policy != SCHED_OTHER) return;
  attributes.size = sizeof attributes;
  attributes.runtime = slice_ns;
  syscall(SYS_sched_setattr, 0, &attributes, 0U);
}
#else
void use_short_slice() noexcept {}
#endif

}  // namespace tfloom
