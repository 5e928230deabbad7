// The sockets of a DDS domain, kept on the loopback interface.
#pragma once

#include <cstdint>
#include <string>

namespace tfloom::dds {

// Bind the UDP sockets on which this process listens in a domain to the loopback interface, so that the kernel drops what
// arrives by any other. The library binds them to all addresses, and has no setting for this.
//
// They are found by their ports, which RTPS defines: a pair for each participant index. The domain must be open with such
// an index, and stay open during the call.
//
// Return the empty string, or the reason why they are not bound; then they are as open as before.
std::string bind_to_loopback(std::uint32_t domain_id);

}  // namespace tfloom::dds
