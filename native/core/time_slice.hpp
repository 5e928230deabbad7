// How long the scheduler lets a thread run in turn with others.
#pragma once

namespace tfloom {

// Have the calling thread run soon after it wakes, even beside threads that compute or wait busily, and for short in turn:
// Linux since 6.12 picks a thread with a shorter slice first, and grants it no more time in sum. Nothing happens on other
// systems, where the system refuses, and for a thread that isn't of the usual scheduling policy. benchmarks/native,
// "short slice".
void use_short_slice() noexcept;

}  // namespace tfloom
