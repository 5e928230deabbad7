// Which vector registers are used where the compiler's default, those of every processor of its kind, are not the widest.
#pragma once

// Functions with this attribute use four doubles at once, and may be called only if `vectors_are_wide()`.
#if defined(__GNUC__) && defined(__x86_64__)
#define TFLOOM_WIDE_TARGET __attribute__((target("avx2,fma")))
#endif

namespace tfloom {

// Return whether this processor has the wide ones, and they are in use.
bool vectors_are_wide();

// Use the wide ones if the processor has them, or else the others. Return which are in use now. For tests.
bool use_wide_vectors(bool are_wide);

}  // namespace tfloom
