// The system's clock, in the unit of all stamps.
#pragma once

#include <chrono>
#include <cstdint>

namespace tfloom {

// Return the time since the epoch [ns].
inline std::int64_t wall_clock_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace tfloom
