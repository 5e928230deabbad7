// The native base class of all Python messages.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>

namespace tfloom::bindings {

// Whether messages check what is assigned to their fields where `check_fields` is not given.
std::atomic<bool>& check_by_default() noexcept;

// Makes `MessageBase` and puts it into the module.
void bind_message_base(nanobind::module_& m);

}  // namespace tfloom::bindings
