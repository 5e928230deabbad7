// An order in which stamps ascend, near enough for histories to be read from old to new.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tf2/errors.hpp"

namespace tfloom::tf2 {

// The indices of all stamps, at most 2³² of them, such that the stamps there ascend but for the smallest differences:
// those of less than a millionth of their whole span.
[[nodiscard]] std::vector<std::uint32_t> nearly_ascending(std::span<const Stamp> stamps);

}  // namespace tfloom::tf2
