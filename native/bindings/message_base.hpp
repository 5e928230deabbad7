// The native base class of all Python messages.
#pragma once

#include <nanobind/nanobind.h>

namespace tfloom::bindings {

// Makes `MessageBase` and puts it into the module.
void bind_message_base(nanobind::module_& m);

}  // namespace tfloom::bindings
