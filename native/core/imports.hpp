// Functions that a loaded shared library, or the program itself, imports, replaced by others.
#pragma once

#include <string>

struct link_map;

namespace tfloom {

// Let a loaded library call `replacement` where it calls its import `name`. The calls of all other libraries remain as they
// are.
// Return the reason why this can't be done here; empty if it is done.
std::string replace_import(const link_map& library, const char* name, void* replacement);

}  // namespace tfloom
