// The native base class of all Python messages.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>

namespace tfloom::bindings {

// Whether messages check assignments to their fields if `check_fields` is not given.
std::atomic<bool>& check_by_default() noexcept;

// Create `MessageBase` and add it to the module.
void bind_message_base(nanobind::module_& m);

}  // namespace tfloom::bindings
