// The datagrams that libddsc sends and receives, seen by `rtps::ServiceForms` and `FlowControl`.
#pragma once

#include <string>

namespace tfloom::dds {

// Let the library that `handle` of dlopen stands for send and receive by way of `rtps::ServiceForms`.
// Return the reason why this can't be done here; empty if it is done.
std::string intercept_packets(void* handle);

// As long as it exists, the heartbeats that this thread sends request acknowledgements, where packets are intercepted.
class AcknowledgementRequest {
 public:
  AcknowledgementRequest();
  ~AcknowledgementRequest();
  AcknowledgementRequest(const AcknowledgementRequest&) = delete;
  AcknowledgementRequest& operator=(const AcknowledgementRequest&) = delete;
};

}  // namespace tfloom::dds
