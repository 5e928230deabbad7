// An order in which stamps nearly ascend, so that histories are read from old to new.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tf2/errors.hpp"

namespace tfloom::tf2 {

// Return the indices of all stamps in an order in which the stamps ascend, except for differences below a millionth of
// their whole span. There may be at most 2³² stamps.
[[nodiscard]] std::vector<std::uint32_t> nearly_ascending(std::span<const Stamp> stamps);

}  // namespace tfloom::tf2
