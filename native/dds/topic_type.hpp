// The type of a topic, as libddsc's functions of serialized samples need it.
#pragma once

#include <cstddef>

#include "dds/library.hpp"

namespace tfloom::dds {

// Return the type of a topic and of its writer. It is valid until the topic is deleted. Throw Error with the library's
// reason.
const Sertype_* type_of(const Library& library, Entity topic, Entity writer);

// Return how many bytes after the beginning of a topic a libddsc without `get_entity_sertype` (0.10) keeps the pointer to
// its type. This is measured, in a domain without a network, because that version has no header with it: a sample that
// the library itself has made names its type, which is then searched for in the topic. It takes milliseconds.
// Throw Error if it isn't found, or if another topic has no type there.
std::size_t measure_type_offset(const Library& library);

}  // namespace tfloom::dds
