// Functions that a loaded shared library imports, replaced by others.
#pragma once

#include <string>

namespace tfloom::dds {

// Let the library that `handle` of dlopen stands for call `replacement` where it calls its import `name`. The calls of all
// other libraries remain as they are.
// Return the reason why this can't be done here; empty if it is done.
std::string replace_import(void* handle, const char* name, void* replacement);

}  // namespace tfloom::dds
