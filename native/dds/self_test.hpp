// A test of libddsc's interface: do its types have the layout that abi.hpp declares?
#pragma once

#include "dds/library.hpp"

namespace tfloom::dds {

// Call each function that fills our memory, or whose memory is read in place, in a domain without a network, and compare
// what it writes with known values, and the bytes around with what was there. This takes milliseconds.
// Throw Error "its <type> differs (<function>): <what was found>".
void run_self_test(const Library& library);

}  // namespace tfloom::dds
