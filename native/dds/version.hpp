// The version of an opened libddsc, from the library itself.
#pragma once

#include <string>

namespace tfloom::dds {

// Return the version that the linker recorded in the library that `handle` opens and that defines `symbol`, `11.0.1`: at
// the end of its SONAME on Linux, or else of its file's name, as the current version of the dylib on macOS. Return the empty string if there is none,
// as in a Windows DLL.
std::string version_of_library(void* handle, const void* symbol);

}  // namespace tfloom::dds
