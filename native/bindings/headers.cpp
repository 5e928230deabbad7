// Sinks that count the frames in headers of messages.

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <vector>

#include "bindings/bindings.hpp"
#include "cdr/header_sink.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

nb::list uses_of(const cdr::HeaderSink& sink) {
  nb::list uses;
  for (const auto& use : sink.uses()) {
    uses.append(nb::make_tuple(nb::bytes(use.publisher.data(), use.publisher.size()), use.frame_id, use.count));
  }
  return uses;
}

}  // namespace

void bind_headers(nb::module_& m) {
  nb::class_<cdr::HeaderSink, Sink>(m, "HeaderSink",
                                    "Counts the frames in the headers of a topic's messages, by publisher.\n\n"
                                    "The messages begin with a `std_msgs/msg/Header`; nothing else is read.")
      .def(nb::init<>())
      .def("uses", &uses_of, nb::sig("def uses(self) -> list[tuple[bytes, str, int]]"),
           "Return the gid of a publisher (16 bytes), a frame id, and the number of messages, for all of these.")
      .def_prop_ro("unreadable_count", &cdr::HeaderSink::unreadable_count,
                   "Number of messages that have no such header.");
}

}  // namespace tfloom::bindings
