// geometry_msgs/msg/TransformStamped in and out of a buffer. Messages of tfloom's classes are read and created by their
// slots; those of other classes, such as a real ROS's, by attribute.
#include <nanobind/nanobind.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "bindings/objects.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

// The plans of TransformStamped and of its nested messages.
struct Plans {
  const ObjectPlan &transform_stamped, &header, &time, &transform, &vector3, &quaternion;

  static const Plans& get() {
    // Not a static local: a thread would hold its lock while `make` runs Python code, which may switch to a thread that
    // waits for the lock.
    static std::atomic<const Plans*> known{nullptr};
    if (const Plans* plans = known.load(std::memory_order_acquire)) return *plans;
    auto made = std::make_unique<const Plans>(make());
    const Plans* first = nullptr;
    if (!known.compare_exchange_strong(first, made.get())) return *first;
    return *made.release();  // never freed, because the classes exist until the process ends
  }

 private:
  static const ObjectPlan& nested(const ObjectPlan& plan, std::size_t index) {
    return static_cast<const ObjectPlan&>(*plan.fields[index].message);
  }
  static Plans make() {
    const nb::object type = nb::module_::import_("tfloom.interfaces.geometry_msgs.msg").attr("TransformStamped");
    const ObjectPlan& stamped = plan_of(reinterpret_cast<PyTypeObject*>(type.ptr()));
    const ObjectPlan &header = nested(stamped, 0), &transform = nested(stamped, 2);
    return {stamped, header, nested(header, 0), transform, nested(transform, 0), nested(transform, 1)};
  }
};

// Return a field of a message: by its slot in a message of the plan's class, else by its name. Invalid, with a Python
// error set, if there is no such attribute.
nb::object field(nb::handle message, const ObjectPlan& plan, std::size_t index) {
  if (Py_TYPE(message.ptr()) == plan.type) {
    nb::object value = held_slot(message.ptr(), plan.offsets[index]);
    if (value.is_valid()) return value;
  }
  return nb::steal(PyObject_GetAttr(message.ptr(), plan.slots[index].name.ptr()));
}

nb::object required(nb::handle message, const ObjectPlan& plan, std::size_t index) {
  nb::object value = field(message, plan, index);
  if (!value.is_valid()) throw nb::python_error();
  return value;
}

template <std::size_t N>
std::array<double, N> numbers(nb::handle part, const ObjectPlan& plan, const char* lack) {
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const nb::object value = field(part, plan, i);
    if (!value.is_valid()) {
      if (PyErr_ExceptionMatches(PyExc_AttributeError) == 0) throw nb::python_error();
      PyErr_Clear();
      throw nb::type_error(lack);
    }
    values[i] = PyFloat_CheckExact(value.ptr()) ? PyFloat_AS_DOUBLE(value.ptr()) : PyFloat_AsDouble(value.ptr());
    if (values[i] == -1.0 && PyErr_Occurred()) throw nb::python_error();
  }
  return values;
}

std::int64_t integer(nb::handle value) {
  int overflow = 0;
  const std::int64_t number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0) throw nb::value_error("a stamp must fit into 64 bits of nanoseconds: years 1677 to 2262");
  if (number == -1 && PyErr_Occurred()) throw nb::python_error();
  return number;
}

// Return sec·10⁹ + nanosec. Checked for overflow, because other classes may hold larger numbers than a message.
std::int64_t joined(nb::handle sec, nb::handle nanosec) {
  const std::int64_t whole = integer(sec), rest = integer(nanosec);
  if (whole > INT64_MAX / ns_per_s - 1 || whole < INT64_MIN / ns_per_s + 1 || rest < 0 || rest >= 5 * ns_per_s) {
    throw nb::value_error("a stamp must fit into 64 bits of nanoseconds: years 1677 to 2262");
  }
  return whole * ns_per_s + rest;
}

nb::object attribute(nb::handle object, const char* name) {
  nb::object value = nb::steal(PyObject_GetAttrString(object.ptr(), name));
  if (!value.is_valid()) {
    if (PyErr_ExceptionMatches(PyExc_AttributeError) == 0) throw nb::python_error();
    PyErr_Clear();
  }
  return value;
}

std::int64_t time_ns(nb::handle time, const ObjectPlan& plan) {
  static PyObject* const nanoseconds = PyUnicode_InternFromString("nanoseconds");
  if (Py_TYPE(time.ptr()) == plan.type) return joined(required(time, plan, 0), required(time, plan, 1));
  const nb::object whole = nb::steal(PyObject_GetAttr(time.ptr(), nanoseconds));
  if (whole.is_valid()) return integer(whole);
  if (PyErr_ExceptionMatches(PyExc_AttributeError) == 0) throw nb::python_error();
  PyErr_Clear();
  const nb::object sec = attribute(time, "sec"), nanosec = attribute(time, "nanosec");
  if (!sec.is_valid() || !nanosec.is_valid()) throw nb::type_error("time must have sec and nanosec, or nanoseconds.");
  return joined(sec, nanosec);
}

std::string_view text_of(nb::handle name, const char* what) {
  Py_ssize_t size = 0;
  if (!PyUnicode_Check(name.ptr())) throw nb::type_error(what);
  const char* text = PyUnicode_AsUTF8AndSize(name.ptr(), &size);
  if (!text) throw nb::python_error();
  return {text, static_cast<std::size_t>(size)};
}

bool set_message(BufferHandle& self, nb::handle message, const NameArgument& authority, bool is_static) {
  const Plans& plans = Plans::get();
  const nb::object header = required(message, plans.transform_stamped, 0);
  const nb::object child = required(message, plans.transform_stamped, 1);
  const nb::object transform = required(message, plans.transform_stamped, 2);
  const nb::object frame = required(header, plans.header, 1);
  const auto p = numbers<3>(required(transform, plans.transform, 0), plans.vector3,
                            "transform.translation must have members x, y, z");
  const auto q = numbers<4>(required(transform, plans.transform, 1), plans.quaternion,
                            "transform.rotation must have members x, y, z, w");
  const tf2::Entry entry{text_of(frame, "header.frame_id must be a str"),
                         text_of(child, "child_frame_id must be a str"),
                         time_ns(required(header, plans.header, 0), plans.time),
                         {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}}};
  return self.buffer->set({&entry, 1}, authority.text, is_static) == 1;
}

template <std::size_t N>
nb::object build(ObjectBuilder& builder, const ObjectPlan& plan, const std::array<double, N>& values) {
  nb::object message = builder.message(plan);
  for (std::size_t i = 0; i < N; ++i) builder.set(message, plan, i, builder.number(values[i]));
  builder.finish(message, plan);
  return message;
}

nb::object build_message(const tf2::StampedTransform& found, nb::handle target, nb::handle source) {
  const Plans& plans = Plans::get();
  const auto& [p, q] = found.value;
  // Round down, because nanosec must not be negative.
  std::int64_t sec = found.stamp / ns_per_s, nanosec = found.stamp % ns_per_s;
  if (nanosec < 0) {
    --sec;
    nanosec += ns_per_s;
  }
  ObjectBuilder builder(nullptr);
  nb::object stamp = builder.message(plans.time);
  builder.set(stamp, plans.time, 0, builder.number(sec));
  builder.set(stamp, plans.time, 1, builder.number(nanosec));
  builder.finish(stamp, plans.time);
  nb::object header = builder.message(plans.header);
  builder.set(header, plans.header, 0, std::move(stamp));
  builder.set(header, plans.header, 1, nb::borrow(target));
  builder.finish(header, plans.header);
  nb::object transform = builder.message(plans.transform);
  builder.set(transform, plans.transform, 0, build(builder, plans.vector3, std::array{p.x, p.y, p.z}));
  builder.set(transform, plans.transform, 1, build(builder, plans.quaternion, std::array{q.x, q.y, q.z, q.w}));
  builder.finish(transform, plans.transform);
  nb::object message = builder.message(plans.transform_stamped);
  builder.set(message, plans.transform_stamped, 0, std::move(header));
  builder.set(message, plans.transform_stamped, 1, nb::borrow(source));
  builder.set(message, plans.transform_stamped, 2, std::move(transform));
  builder.finish(message, plans.transform_stamped);
  return message;
}

nb::object message_or_raise(const tf2::Result<tf2::StampedTransform>& found, const NameArgument& target,
                            const NameArgument& source) {
  if (!found) raise(found.error());
  return build_message(*found, target.object, source.object);
}

}  // namespace

void bind_tf2_messages(nb::class_<BufferHandle>& type) {
  type.def("set_message", &set_message, "transform"_a, "authority"_a.none(), "static"_a = false,
           nb::sig("def set_message(self, transform: object, authority: str, static: bool = False) -> bool"),
           "Store a `geometry_msgs/msg/TransformStamped` of any class with its fields. Return False if it is rejected."
           "\n\nRaises TypeError if a field lacks a member.")
      .def(
          "lookup_message",
          [](const BufferHandle& self, const NameArgument& target, const NameArgument& source, nb::handle time) {
            const std::int64_t stamp = time_ns(time, Plans::get().time);
            return message_or_raise(self.buffer->lookup(tf2::Query::at(target.text, source.text, stamp)), target,
                                    source);
          },
          "target_frame"_a.none(), "source_frame"_a.none(), "time"_a.none(),
          nb::sig("def lookup_message(self, target_frame: str, source_frame: str, time: object) -> typing.Any"),
          "Return the result of `lookup` as a `geometry_msgs/msg/TransformStamped`.\n\n"
          "`time` has `nanoseconds`, or `sec` and `nanosec`; TypeError if it has neither.")
      .def(
          "lookup_message_full",
          [](const BufferHandle& self, const NameArgument& target, nb::handle target_time, const NameArgument& source,
             nb::handle source_time, const NameArgument& fixed) {
            const ObjectPlan& plan = Plans::get().time;
            const tf2::Query query{target.text, source.text, time_ns(target_time, plan), time_ns(source_time, plan),
                                   fixed.text};
            return message_or_raise(self.buffer->lookup(query), target, source);
          },
          "target_frame"_a.none(), "target_time"_a.none(), "source_frame"_a.none(), "source_time"_a.none(),
          "fixed_frame"_a.none(),
          nb::sig("def lookup_message_full(self, target_frame: str, target_time: object, source_frame: str, "
                  "source_time: object, fixed_frame: str) -> typing.Any"),
          "Return the result of `lookup_full` as a `geometry_msgs/msg/TransformStamped`; see `lookup_message`.");
}

}  // namespace tfloom::bindings
