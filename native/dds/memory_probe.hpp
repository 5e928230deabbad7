// Memory that may not be there: what a struct of an unknown layout seems to point to.
#pragma once

#include <cstddef>

namespace tfloom::dds {

// Copy `size` bytes, at most those that a pipe holds, from `place`. Return false if they can't be read, where the system
// reports that: on Windows a place that isn't null is read at once.
bool copy_if_readable(const void* place, void* copy, std::size_t size);

// Return whether the memory can be read.
bool is_readable(const void* place, std::size_t size);

// Return whether a text of a library is `expected`, with its terminating zero.
bool is_text(const char* found, const char* expected);

}  // namespace tfloom::dds
