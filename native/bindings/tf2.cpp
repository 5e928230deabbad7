// The buffer of transforms: lookups, errors and frames.

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "bindings/bindings.hpp"
#include "bindings/gil.hpp"
#include "bindings/callback.hpp"
#include "bindings/objects.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"
#include "tf2/buffer.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {

nb::object exception_of(const tf2::Error& error) {
  static constexpr std::array names{"TransformException",        "LookupException",
                                    "ConnectivityException",     "ExtrapolationException",
                                    "InvalidArgumentException",  "TimeoutException",
                                    "TransformException",        "BackwardExtrapolationException",
                                    "ForwardExtrapolationException", "NoDataForExtrapolationException"};
  const nb::object type = nb::module_::import_("tfloom.tf2.errors").attr(names[static_cast<std::size_t>(error.code)]);
  nb::object exception = type(error.text);
  if (!error.frame.empty()) exception.attr("frame_id") = error.frame;
  if (error.is_extrapolation()) {
    exception.attr("requested_ns") = error.requested;
    if (error.newest != 0 || error.oldest != 0) {
      exception.attr("oldest_ns") = error.oldest;
      exception.attr("newest_ns") = error.newest;
    }
  }
  return exception;
}

void raise_wrong_argument(const char* wanted, nb::handle given) {
  const AcquiredGil gil;
  if (!gil) throw nb::type_error(wanted);
  throw nb::type_error((wanted + (", not " + shown(given)) + " of class " + Py_TYPE(given.ptr())->tp_name).c_str());
}

void raise(const tf2::Error& error) {
  const nb::object exception = exception_of(error);
  PyErr_SetObject(exception.type().ptr(), exception.ptr());
  throw nb::python_error();
}

namespace {

using tf2::Query;

// The result of a lookup. The names are the str objects passed by the caller. They are exactly str, so that no cycle of
// references can pass through them, and the garbage collector need not track each answer.
struct Answer {
  nb::object frame_id, child_frame_id;
  tf2::StampedTransform transform;
};

nb::tuple translation_of(const Answer& answer) {
  const auto& p = answer.transform.value.translation;
  return nb::make_tuple(p.x, p.y, p.z);
}

nb::tuple rotation_of(const Answer& answer) {
  const auto& q = answer.transform.value.rotation;
  return nb::make_tuple(q.x, q.y, q.z, q.w);
}

nb::object exact_str(const NameArgument& name) {
  if (PyUnicode_CheckExact(name.object.ptr())) return nb::borrow(name.object);
  auto text = nb::steal(PyUnicode_FromObject(name.object.ptr()));  // of a subclass: a copy
  if (!text.is_valid()) throw nb::python_error();
  return text;
}

Answer answer_or_raise(const tf2::Result<tf2::StampedTransform>& result, const NameArgument& target,
                       const NameArgument& source) {
  if (!result) raise(result.error());
  return {exact_str(target), exact_str(source), *result};
}

Query full_query(const NameArgument& target, StampArgument target_stamp, const NameArgument& source,
                 StampArgument source_stamp, const NameArgument& fixed) {
  return {target.text, source.text, target_stamp.value, source_stamp.value, fixed.text};
}

Query simple_query(const NameArgument& target, const NameArgument& source, StampArgument stamp) {
  return Query::at(target.text, source.text, stamp.value);
}

std::optional<std::string> text_or_none(const tf2::Error& error) {
  if (error.code == tf2::Code::ok) return std::nullopt;
  return error.text;
}

std::chrono::steady_clock::time_point deadline_after(double timeout_s) {
  using Clock = std::chrono::steady_clock;
  constexpr double max_s = 1e9;  // about thirty years, as a wait without limit
  if (std::isnan(timeout_s)) throw nb::value_error("timeout_s must be a number of seconds, not NaN");
  const std::chrono::duration<double> timeout(std::clamp(timeout_s, 0.0, max_s));
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
}

bool wait(const tf2::Buffer& buffer, const Query& query, double timeout_s) {
  const auto deadline = deadline_after(timeout_s);
  for (;;) {
    tf2::Buffer::Waited waited;
    {
      const GilReleasedForWait release;
      waited = buffer.wait(query, deadline, std::chrono::milliseconds(50));
    }
    if (waited != tf2::Buffer::Waited::interrupted) return waited == tf2::Buffer::Waited::yes;
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
  }
}

// Signatures for the stub: (handle, is_available) and (severity, text).
using RequestCallable = nb::typed<nb::callable, void(std::uint64_t, bool)>;
using LogCallable = nb::typed<nb::callable, void(int, std::string)>;

// The functions that a buffer calls back; classes, so that `traverse` finds their callables.
struct RequestFunction {
  Callback callback;
  void operator()(tf2::Requests::Handle handle, tf2::Requests::Outcome outcome) const {
    callback(handle, outcome == tf2::Requests::Outcome::available);
  }
};

struct LogFunction {
  Callback callback;
  void operator()(tf2::Severity severity, const std::string& text) const {
    callback(static_cast<int>(severity), text);
  }
};

template <class Function, class Signature>
int traverse(const std::function<Signature>& function, visitproc visit, void* argument) {
  const auto* found = function.template target<Function>();
  return found == nullptr ? 0 : found->callback.traverse(visit, argument);
}

// The buffer's slots of the garbage collector. A callback often refers to its buffer, a future's always does, so the
// collector has to find the callables of a buffer to free both.
int traverse_buffer(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;  // the collector may run before the end of __init__
  const tf2::Buffer& buffer = *nb::inst_ptr<BufferHandle>(self)->buffer;
  int result = 0;
  buffer.log().visit_callback([&](const tf2::LogCallback& log) { result = traverse<LogFunction>(log, visit, arg); });
  buffer.requests().for_each_callback([&](const tf2::Requests::Callback& request) {
    if (result == 0) result = traverse<RequestFunction>(request, visit, arg);
  });
  return result;
}

int clear_buffer(PyObject* self) {
  if (nb::inst_ready(self)) nb::inst_ptr<BufferHandle>(self)->buffer->drop_callbacks();
  return 0;
}

// Runs on a buffer that the collector found unreachable, before anything is cleared. A sink that still fills the buffer
// may have begun a call since then: with the buffer's own reference gone, the collector finds the callable reachable by
// that call, and frees it later.
void finalize_buffer(PyObject* self) {
  PyObject *type, *value, *traceback;
  PyErr_Fetch(&type, &value, &traceback);
  clear_buffer(self);
  PyErr_Restore(type, value, traceback);
}

PyType_Slot buffer_slots[] = {
    {Py_tp_traverse, reinterpret_cast<void*>(&traverse_buffer)},
    {Py_tp_clear, reinterpret_cast<void*>(&clear_buffer)},
    {Py_tp_finalize, reinterpret_cast<void*>(&finalize_buffer)},
    {0, nullptr},
};

std::optional<tf2::Requests::Handle> handle_or_none(tf2::Requests::Handle handle) {
  if (handle == tf2::Requests::never) return std::nullopt;
  return handle;
}

void bind_answer(nb::module_& m) {
  nb::class_<Answer>(m, "StampedTransform", "The result of a lookup: target_from_source at a time.")
      .def_prop_ro("stamp_ns", [](const Answer& a) { return a.transform.stamp; }, "Time [ns since epoch].")
      .def_prop_ro("frame_id", [](const Answer& a) { return nb::borrow<nb::str>(a.frame_id); },
                   "The target frame, in which transformed data is expressed.")
      .def_prop_ro("child_frame_id", [](const Answer& a) { return nb::borrow<nb::str>(a.child_frame_id); },
                   "The source frame.")
      .def_prop_ro("translation", &translation_of,
                   nb::sig("def translation(self) -> tuple[float, float, float]"),
                   "Position of the source frame's origin in the target frame [m].")
      .def_prop_ro("rotation_xyzw", &rotation_of,
                   nb::sig("def rotation_xyzw(self) -> tuple[float, float, float, float]"),
                   "Unit quaternion x, y, z, w.")
      .def_prop_ro("transform", [](const Answer& a) { return a.transform.value; }, "The translation and rotation.")
      .def("__repr__", [](const Answer& a) {
        return nb::str("StampedTransform({!r} from {!r}, stamp_ns={}, translation={}, rotation_xyzw={})")
            .format(a.frame_id, a.child_frame_id, a.transform.stamp, translation_of(a), rotation_of(a));
      });
}

void bind_queries(nb::class_<BufferHandle>& type) {
  type.def(
          "lookup",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp) {
            return answer_or_raise(self.buffer->lookup(simple_query(target, source, stamp)), target, source);
          },
          "target_frame"_a.none(), "source_frame"_a.none(), "stamp_ns"_a.none() = 0,
          nb::sig("def lookup(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> StampedTransform"),
          "Return target_from_source: the transform that takes data in `source_frame` into `target_frame`.\n\n"
          "Between two stored stamps, translation is interpolated linearly and rotation by slerp.\n\n"
          "Args:\n"
          "    target_frame: Frame to express the data in.\n"
          "    source_frame: Frame the data is in now.\n"
          "    stamp_ns: Time of the transform [ns since epoch]; 0 is the newest time at which the whole chain is "
          "known.\n\n"
          "Returns:\n"
          "    Translation [m] and unit quaternion (x, y, z, w), stamped with the time used.\n\n"
          "Raises:\n"
          "    LookupException: a frame is unknown, or the chain is a loop.\n"
          "    ConnectivityException: the two frames are in different trees.\n"
          "    ExtrapolationException: `stamp_ns` lies outside the stored history.\n"
          "    InvalidArgumentException: a frame's name is empty or starts with a slash.")
      .def(
          "lookup_full",
          [](const BufferHandle& self, const NameArgument& target, StampArgument target_stamp,
             const NameArgument& source, StampArgument source_stamp, const NameArgument& fixed) {
            return answer_or_raise(self.buffer->lookup(full_query(target, target_stamp, source, source_stamp, fixed)),
                                   target, source);
          },
          "target_frame"_a.none(), "target_stamp_ns"_a.none(), "source_frame"_a.none(), "source_stamp_ns"_a.none(),
          "fixed_frame"_a.none(),
          nb::sig("def lookup_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, "
                  "source_stamp_ns: int, fixed_frame: str) -> StampedTransform"),
          "Return target_from_source between two times: from the source at `source_stamp_ns`, through `fixed_frame`, "
          "which is assumed not to move, to the target at `target_stamp_ns`.\n\n"
          "The result is stamped with the target's time. Raises as `lookup` does.")
      .def(
          "can",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp) {
            return self.buffer->can(simple_query(target, source, stamp));
          },
          "target_frame"_a.none(), "source_frame"_a.none(), "stamp_ns"_a.none() = 0,
          nb::sig("def can(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> bool"),
          "Return whether `lookup` with the same arguments would succeed.")
      .def(
          "can_full",
          [](const BufferHandle& self, const NameArgument& target, StampArgument target_stamp,
             const NameArgument& source, StampArgument source_stamp, const NameArgument& fixed) {
            return self.buffer->can(full_query(target, target_stamp, source, source_stamp, fixed));
          },
          "target_frame"_a.none(), "target_stamp_ns"_a.none(), "source_frame"_a.none(), "source_stamp_ns"_a.none(),
          "fixed_frame"_a.none(),
          nb::sig("def can_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, "
                  "source_stamp_ns: int, fixed_frame: str) -> bool"),
          "Return whether `lookup_full` with the same arguments would succeed.")
      .def(
          "find_obstacle",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp) {
            return text_or_none(self.buffer->check(simple_query(target, source, stamp)));
          },
          "target_frame"_a.none(), "source_frame"_a.none(), "stamp_ns"_a.none() = 0,
          nb::sig("def find_obstacle(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> str | None"),
          "Return tf2's text of the reason why `can` is false, or None if it is true.")
      .def(
          "find_obstacle_full",
          [](const BufferHandle& self, const NameArgument& target, StampArgument target_stamp,
             const NameArgument& source, StampArgument source_stamp, const NameArgument& fixed) {
            return text_or_none(self.buffer->check(full_query(target, target_stamp, source, source_stamp, fixed)));
          },
          "target_frame"_a.none(), "target_stamp_ns"_a.none(), "source_frame"_a.none(), "source_stamp_ns"_a.none(),
          "fixed_frame"_a.none(),
          nb::sig("def find_obstacle_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, "
                  "source_stamp_ns: int, fixed_frame: str) -> str | None"),
          "Return tf2's text of the reason why `can_full` is false, or None if it is true.")
      .def(
          "latest_common_time",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source) {
            const auto result = self.buffer->latest_common_time(target.text, source.text);
            if (!result) raise(result.error());
            return *result;
          },
          "target_frame"_a, "source_frame"_a,
          "Return the newest time at which the whole chain is known [ns since epoch]; 0 if all of it is static.\n\n"
          "Raises LookupException, ConnectivityException or InvalidArgumentException as `lookup` does.");
}

void bind_waiting(nb::class_<BufferHandle>& type) {
  type.def(
          "wait",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp,
             double timeout_s) { return wait(*self.buffer, simple_query(target, source, stamp), timeout_s); },
          "target_frame"_a, "source_frame"_a, "stamp_ns"_a = 0, nb::kw_only(), "timeout_s"_a,
          "Wait until `lookup` would succeed, and return True.\n\n"
          "Returns False after `timeout_s`, or as soon as it can never succeed because the stamp is older than the "
          "cache keeps or a name is invalid.\n\n"
          "Returns within a millisecond after the missing transform is stored. Releases the GIL. Signal handlers run, "
          "and their exceptions are raised here.")
      .def(
          "wait_full",
          [](const BufferHandle& self, const NameArgument& target, StampArgument target_stamp,
             const NameArgument& source, StampArgument source_stamp, const NameArgument& fixed, double timeout_s) {
            return wait(*self.buffer, full_query(target, target_stamp, source, source_stamp, fixed), timeout_s);
          },
          "target_frame"_a, "target_stamp_ns"_a, "source_frame"_a, "source_stamp_ns"_a, "fixed_frame"_a,
          nb::kw_only(), "timeout_s"_a, "Wait until `lookup_full` would succeed; see `wait`.")
      .def(
          "add_request",
          [](BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp,
             const RequestCallable& callback) {
            const Query query = simple_query(target, source, stamp);
            return handle_or_none(self.buffer->add_request(query, RequestFunction{Callback(callback)}));
          },
          "target_frame"_a, "source_frame"_a, "stamp_ns"_a, "callback"_a,
          nb::sig("def add_request(self, target_frame: str, source_frame: str, stamp_ns: int, callback: "
                  "collections.abc.Callable[[int, bool], object]) -> int | None"),
          "Call `callback(handle, is_available)` once when `lookup` would succeed.\n\n"
          "It is called on the thread that stores the transform. `is_available` is False if the stamp has become older "
          "than the cache keeps.\n\n"
          "Returns the request's handle; or, without a call, 0 if `lookup` succeeds now and None if it never can.")
      .def(
          "add_request_full",
          [](BufferHandle& self, const NameArgument& target, StampArgument target_stamp, const NameArgument& source,
             StampArgument source_stamp, const NameArgument& fixed, const RequestCallable& callback) {
            const Query query = full_query(target, target_stamp, source, source_stamp, fixed);
            return handle_or_none(self.buffer->add_request(query, RequestFunction{Callback(callback)}));
          },
          "target_frame"_a, "target_stamp_ns"_a, "source_frame"_a, "source_stamp_ns"_a, "fixed_frame"_a,
          "callback"_a,
          nb::sig("def add_request_full(self, target_frame: str, target_stamp_ns: int, source_frame: str, "
                  "source_stamp_ns: int, fixed_frame: str, callback: collections.abc.Callable[[int, bool], object]) "
                  "-> int | None"),
          "Call `callback(handle, is_available)` once when `lookup_full` would succeed; see `add_request`.")
      .def(
          "cancel_request",
          [](BufferHandle& self, tf2::Requests::Handle handle) { return self.buffer->cancel_request(handle); },
          "handle"_a, "Cancel a request. Return False if it is completed or unknown.");
}

void bind_contents(nb::class_<BufferHandle>& type) {
  type.def(
          "set",
          [](BufferHandle& self, const NameArgument& frame_id, const NameArgument& child_frame_id, StampArgument stamp,
             const NumbersArgument<3>& translation, const NumbersArgument<4>& rotation, const NameArgument& authority,
             bool is_static) {
            const auto& p = translation.values;
            const auto& q = rotation.values;
            const tf2::Entry entry{frame_id.text,
                                   child_frame_id.text,
                                   stamp.value,
                                   {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}}};
            return self.buffer->set({&entry, 1}, authority.text, is_static) == 1;
          },
          "frame_id"_a.none(), "child_frame_id"_a.none(), "stamp_ns"_a.none(), "translation"_a.none(),
          "rotation_xyzw"_a.none(), "authority"_a.none() = "", "static"_a = false,
          nb::sig("def set(self, frame_id: str, child_frame_id: str, stamp_ns: int, translation: "
                  "collections.abc.Sequence[float], rotation_xyzw: collections.abc.Sequence[float], authority: str = "
                  "'', static: bool = False) -> bool"),
          "Store parent_from_child at a time, or for all times if `static`.\n\n"
          "Args:\n"
          "    frame_id: The parent frame. One leading slash is dropped, here and in the child's name.\n"
          "    child_frame_id: The child frame.\n"
          "    stamp_ns: Time of the transform [ns since epoch].\n"
          "    translation: x, y, z of the child's origin in the parent [m].\n"
          "    rotation_xyzw: Quaternion of any length but zero; it is normalised.\n"
          "    authority: Name of the publisher, for the listings.\n"
          "    static: Whether it is valid at all times.\n\n"
          "Returns:\n"
          "    False if it was rejected because a name is missing, both are the same, a number is NaN, the quaternion "
          "is zero, or it is older than the cache keeps. The log callback is called with the reason.")
      .def(
          "clear", [](BufferHandle& self) { self.buffer->clear(); }, nb::call_guard<ReleasedGil>(),
          "Clear the history of all moving frames. Static transforms and frames' names stay.")
      .def(
          "ignore_from",
          [](BufferHandle& self, StampArgument stamp, double duration_s) {
            self.buffer->ignore_from(stamp.value, deadline_after(duration_s) - std::chrono::steady_clock::now());
          },
          "stamp_ns"_a, "duration_s"_a,
          "Reject moving transforms from `stamp_ns` on, without logging them, for `duration_s` of real time.\n\n"
          "For a jump back in time: rejects transforms sent before it and received after it.")
      .def_prop_ro(
          "cache_time_ns",
          [](const BufferHandle& self) -> std::optional<tf2::Stamp> {
            if (self.buffer->cache_time() == tf2::unlimited) return std::nullopt;
            return self.buffer->cache_time();
          },
          "Length of each frame's history, back from its newest sample [ns]; None if without limit.")
      .def(
          "set_log_callback",
          [](BufferHandle& self, std::optional<LogCallable> callback) {
            if (!callback) return self.buffer->set_log_callback({});
            self.buffer->set_log_callback(LogFunction{Callback(*callback)});
          },
          "callback"_a.none(),
          nb::sig("def set_log_callback(self, callback: collections.abc.Callable[[int, str], object] | None) -> None"),
          "Set the function called for rejected data: `callback(severity, text)`, severity as in Python's logging.\n\n"
          "It is called on the thread that inserts the data, at most once a second for each frame and kind of error; "
          "the next text then states how many were held back. None: no function.");
}

void bind_listings(nb::class_<BufferHandle>& type) {
  type.def(
          "frame_names", [](const BufferHandle& self) { return self.buffer->frame_names(); },
          nb::call_guard<ReleasedGil>(), "Return the names of all frames, in order of first mention.")
      .def(
          "has_frame",
          [](const BufferHandle& self, const NameArgument& name) { return self.buffer->has_frame(name.text); },
          "frame_id"_a, "Return whether a frame is known.")
      .def(
          "branches",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp) {
            const auto result = self.buffer->branches(target.text, source.text, stamp.value);
            if (!result) raise(result.error());
            return nb::make_tuple(result->target, result->source);
          },
          "target_frame"_a, "source_frame"_a, "stamp_ns"_a = 0,
          nb::sig("def branches(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> tuple[list[str], "
                  "list[str]]"),
          "Return the frames whose data a lookup reads: the target's branch and the source's, each from the bottom up "
          "to below the root, or below the other end. Raises as `lookup` does.")
      .def(
          "path",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, StampArgument stamp) {
            const auto result = self.buffer->branches(target.text, source.text, stamp.value);
            if (!result) raise(result.error());
            return result->path();
          },
          "target_frame"_a, "source_frame"_a, "stamp_ns"_a = 0,
          nb::sig("def path(self, target_frame: str, source_frame: str, stamp_ns: int = 0) -> list[str]"),
          "Return the frames of a lookup's chain, from the source to the target. Raises as `lookup` does.")
      .def(
          "all_frames_as_string", [](const BufferHandle& self) { return self.buffer->all_frames_as_string(); },
          nb::call_guard<ReleasedGil>(), "Return a line for each frame with a parent.")
      .def(
          "all_frames_as_yaml",
          [](const BufferHandle& self, double now_s) { return self.buffer->all_frames_as_yaml(now_s); },
          "now_s"_a = 0.0, nb::call_guard<ReleasedGil>(),
          "Return each frame's parent, broadcaster, rate and times as YAML, and its delay if `now_s` is given.")
      .def(
          "all_frames_as_dot",
          [](const BufferHandle& self, double now_s) { return self.buffer->all_frames_as_dot(now_s); },
          "now_s"_a = 0.0, nb::call_guard<ReleasedGil>(), "Return the tree in graphviz's DOT language.");
}

}  // namespace

void bind_tf2(nb::module_& m) {
  bind_tf2_transform(m);
  bind_answer(m);
  nb::class_<BufferHandle> type(m, "Buffer", nb::type_slots(buffer_slots),
                                "A tree of frames over time; see `tfloom.tf2.buffer.Buffer`.");
  type.def(
      "__init__",
      [](BufferHandle* self, const AgeArgument& cache_time) {
        if (cache_time.value < 0) throw nb::value_error("cache_time_ns must not be negative");
        new (self) BufferHandle{std::make_shared<tf2::Buffer>(cache_time.value)};
      },
      "cache_time_ns"_a.none() = tf2::Buffer::default_cache_time,
      "Create an empty buffer; see `cache_time_ns`.");
  bind_queries(type);
  bind_waiting(type);
  bind_contents(type);
  bind_listings(type);
  bind_tf2_batch(m, type);
  bind_tf2_frozen(type);
  bind_tf2_messages(type);
  bind_tf2_wire(m, type);
  bind_tf2_observer(m);
}

}  // namespace tfloom::bindings
