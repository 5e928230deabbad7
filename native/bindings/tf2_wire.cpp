#include <nanobind/nanobind.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/string.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/gil.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"
#include "cdr/cursor.hpp"
#include "cdr/tf_message.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

std::size_t insert_cdr(BufferHandle& self, const nb::bytes& data, const NameArgument& authority, bool is_static) {
  const std::span octets(static_cast<const std::byte*>(data.data()), data.size());
  const ReleasedGil release;
  std::vector<tf2::Entry> entries;
  try {
    cdr::read_tf_message(octets, entries);
  } catch (const cdr::DecodeError& error) {
    const std::string path = error.path.empty() ? "TFMessage" : "TFMessage." + error.path;
    throw std::invalid_argument(path + ": byte " + std::to_string(error.offset) + ": " + error.what());
  }
  return self.buffer->set(entries, authority.text, is_static);
}

}  // namespace

void bind_tf2_wire(nb::module_& m, nb::class_<BufferHandle>& type) {
  nb::class_<cdr::TfSink, Sink>(m, "TfSink",
                                "A sink that stores the samples of /tf or /tf_static in a buffer, without Python.")
      .def_prop_ro("message_count", &cdr::TfSink::message_count, "Number of messages received.")
      .def_prop_ro("dropped_count", &cdr::TfSink::dropped_count, "Number of unreadable messages, which were dropped.");
  type.def(
          "tf_sink",
          [](const BufferHandle& self, std::string authority, bool is_static) {
            return std::make_unique<cdr::TfSink>(self.buffer, std::move(authority), is_static);
          },
          "authority"_a, "static"_a,
          "Return a sink for `Reader.feed` that stores samples of `tf2_msgs/msg/TFMessage` here.\n\n"
          "An unreadable message is dropped whole, and the log callback is called.")
      .def("insert_cdr", &insert_cdr, "data"_a, "authority"_a = "", "static"_a = false,
           "Store the transforms of a `tf2_msgs/msg/TFMessage`, given as encapsulation header and CDR.\n\n"
           "Returns how many were stored; the others were rejected, as by `set`. Raises ValueError, with nothing "
           "stored, if the bytes are no such message.");
}

}  // namespace tfloom::bindings
