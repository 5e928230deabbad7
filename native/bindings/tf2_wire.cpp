// Sinks that store received transforms in a buffer.

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/callback.hpp"
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
  const std::span bytes(static_cast<const std::byte*>(data.data()), data.size());
  const ReleasedGil release;
  std::vector<tf2::Entry> entries;
  try {
    cdr::read_tf_message(bytes, entries);
  } catch (const cdr::DecodeError& error) {
    const std::string path = error.path.empty() ? "TFMessage" : "TFMessage." + error.path;
    throw std::invalid_argument(path + ": byte " + std::to_string(error.offset) + ": " + error.what());
  }
  return self.buffer->set(entries, authority.text, is_static);
}

// The function that a sink calls back; a class, so that `traverse_sink` finds its callable.
struct HeldFunction {
  Callback callback;
  void operator()(const Gid& publisher, const std::string& child_frame_id, tf2::Stamp stamp, tf2::Stamp now) const {
    callback(publisher, child_frame_id, stamp, now);
  }
};

int traverse_sink(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  const auto* held = nb::inst_ptr<cdr::TfSink>(self)->on_held().target<HeldFunction>();
  return held == nullptr ? 0 : held->callback.traverse(visit, arg);
}

// There is no tp_clear: the callable is constant, because other threads call it. A cycle through it is freed by clearing
// another object in it; a callable that refers to its sink has a closure, or an instance, that can be cleared.
PyType_Slot sink_slots[] = {
    {Py_tp_traverse, reinterpret_cast<void*>(&traverse_sink)},
    {0, nullptr},
};

std::unique_ptr<cdr::TfSink> make_tf_sink(const BufferHandle& self, std::string authority, bool is_static,
                                       std::optional<nb::callable> on_held) {
  cdr::HeldCallback callback;
  if (on_held) callback = HeldFunction{Callback(*on_held)};
  return std::make_unique<cdr::TfSink>(self.buffer, std::move(authority), is_static, std::move(callback));
}

}  // namespace

void bind_tf2_wire(nb::module_& m, nb::class_<BufferHandle>& type) {
  nb::class_<cdr::TfSink, Sink>(m, "TfSink", nb::type_slots(sink_slots),
                                "A sink that stores the samples of /tf or /tf_static in a buffer, without Python.")
      .def_prop_ro("message_count", &cdr::TfSink::message_count, "Number of messages received.")
      .def_prop_ro("dropped_count", &cdr::TfSink::dropped_count, "Number of unreadable messages, which were dropped.")
      .def_prop_ro("held_count", &cdr::TfSink::held_count, "Number of transforms that are held now.")
      .def_prop_ro("publisher_count", &cdr::TfSink::publisher_count,
                   "Number of publishers whose stamps are remembered, if transforms are held.")
      .def("set_simulated_time", &cdr::TfSink::set_simulated_time, "now_ns"_a.none(),
           "Set the time with which stamps are compared [ns since epoch]; 0: unknown, nothing is held; None: the "
           "system's.")
      .def("forget_all", &cdr::TfSink::forget_all,
           "Drop what is held, and forget all publishers' stamps, after a jump in time.");
  type.def(
          "tf_sink",
          &make_tf_sink, "authority"_a, "static"_a, "on_held"_a.none() = nb::none(),
          nb::sig("def tf_sink(self, authority: str, static: bool, on_held: "
                  "collections.abc.Callable[[list[int], str, int, int], object] | None = None) -> TfSink"),
          "Return a sink for `Reader.feed` that stores samples of `tf2_msgs/msg/TFMessage` here.\n\n"
          "An unreadable message is dropped whole, and the log callback is called. With `on_held`, a moving transform "
          "stamped further ahead of now than the cache is long, and than its publisher's former ones, is held until "
          "that publisher confirms it by a later one. `on_held(gid, child_frame_id, stamp_ns, now_ns)` is called for "
          "the first one of each publisher, on any thread.")
      .def("insert_cdr", &insert_cdr, "data"_a, "authority"_a = "", "static"_a = false,
           "Store the transforms of a `tf2_msgs/msg/TFMessage`, given as encapsulation header and CDR.\n\n"
           "Returns how many were stored; the others were rejected, as by `set`. Raises ValueError, with nothing "
           "stored, if the bytes are not such a message.");
}

}  // namespace tfloom::bindings
