// What the classes of KDL have in common: a header, operators, copies, pickling.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <utility>

#include "kdl/frame.hpp"

namespace tfloom::bindings {

namespace kdl_values {

namespace nb = nanobind;

// The component i of a vector, a twist or a wrench; raises IndexError.
double& component(tf2::Vector3& v, int i);
template <kdl::Screw T>
double& component(T& screw, int i);

[[nodiscard]] std::string text(const tf2::Vector3& v);
[[nodiscard]] std::string text(const kdl::Rotation& r);
[[nodiscard]] std::string text(const kdl::Frame& f);
template <kdl::Screw T>
[[nodiscard]] std::string text(const T& screw);

[[nodiscard]] nb::tuple numbers(const tf2::Vector3& v);
template <kdl::Screw T>
[[nodiscard]] nb::tuple numbers(const T& screw);

// The numbers that pickle stores, and the value that has them.
[[nodiscard]] nb::tuple state(const tf2::Vector3& v);
[[nodiscard]] nb::tuple state(const kdl::Rotation& r);
[[nodiscard]] nb::tuple state(const kdl::Frame& f);
template <kdl::Screw T>
[[nodiscard]] nb::tuple state(const T& screw);
void restore(tf2::Vector3& v, const nb::tuple& parts);
void restore(kdl::Rotation& r, const nb::tuple& parts);
void restore(kdl::Frame& f, const nb::tuple& parts);
template <kdl::Screw T>
void restore(T& screw, const nb::tuple& parts);

inline nb::dict attributes(nb::handle self) { return nb::cast<nb::dict>(self.attr("__dict__")); }

template <typename T>
nb::object copy_of(nb::handle self, const nb::object& own_attributes) {
  nb::object result = nb::cast(T(nb::cast<const T&>(self)));
  attributes(result).update(nb::cast<nb::dict>(own_attributes));
  return result;
}

// The numbers, and the attributes if there are any.
template <typename T>
nb::tuple pickled(nb::handle self) {
  nb::tuple numbers = state(nb::cast<const T&>(self));
  if (nb::len(attributes(self)) == 0) return numbers;
  return nb::make_tuple(numbers, attributes(self));
}

template <typename T>
void unpickle(nb::pointer_and_handle<T> self, const nb::tuple& given) {
  new (self.p) T();
  const bool has_attributes = nb::len(given) == 2 && nb::isinstance<nb::dict>(given[1]);
  restore(*self.p, has_attributes ? nb::cast<nb::tuple>(given[0]) : given);
  if (has_attributes) attributes(self.h).update(nb::cast<nb::dict>(given[1]));
}

template <typename T>
nb::class_<T> value_class(nb::module_& m, const char* name, const char* doc) {
  nb::class_<T> type(m, name, nb::dynamic_attr(), doc);
  type.def(nb::init<>(), "Create zero, or the identity.")
      .def(nb::init<const T&>(), nb::arg("other"), "Create a copy without its header.")
      .def("__eq__", [](const T& a, const T& b) { return kdl::equal(a, b, kdl::epsilon); }, nb::is_operator(),
           nb::arg("other"), nb::sig("def __eq__(self, other: object, /) -> bool"),
           "Return whether all numbers differ by less than 1e-6.")
      .def("__ne__", [](const T& a, const T& b) { return !kdl::equal(a, b, kdl::epsilon); }, nb::is_operator(),
           nb::arg("other"), nb::sig("def __ne__(self, other: object, /) -> bool"),
           "Return whether any number differs by 1e-6 or more.")
      .def("__repr__", [](const T& self) { return text(self); }, "Return the numbers with six digits.")
      .def("__copy__", [](nb::handle self) { return copy_of<T>(self, attributes(self)); },
           nb::sig("def __copy__(self) -> typing.Any"), "Return a copy with the same attributes.")
      .def("__deepcopy__",
           [](nb::handle self, nb::handle memo) {
             return copy_of<T>(self, nb::module_::import_("copy").attr("deepcopy")(attributes(self), memo));
           },
           nb::arg("memo"), nb::sig("def __deepcopy__(self, memo: dict[int, typing.Any]) -> typing.Any"),
           "Return a copy with copies of the attributes.")
      .def("__getstate__", &pickled<T>, nb::sig("def __getstate__(self) -> tuple[typing.Any, ...]"),
           "Return the numbers, and the attributes if there are any.")
      .def("__setstate__", &unpickle<T>, nb::arg("state"),
           nb::sig("def __setstate__(self, state: tuple[typing.Any, ...]) -> None"),
           "Set what `__getstate__` returned, here or in Orocos' PyKDL.")
      .def_prop_rw("header",
                   [](nb::handle self) {
                     const nb::dict known = attributes(self);
                     if (!known.contains("header")) throw nb::attribute_error("no header is set: see tf2_ros.Stamped");
                     return nb::object(known["header"]);
                   },
                   [](nb::handle self, nb::handle header) { attributes(self)["header"] = header; },
                   nb::for_getter(nb::sig("def header(self) -> typing.Any")),
                   nb::for_setter(nb::sig("def header(self, header: object) -> None")),
                   "The stamp and frame of a value that tf2_kdl converts. Raises AttributeError if none is set.");
  type.attr("__hash__") = nb::none();
  return type;
}

// What vectors, twists and wrenches share.
template <typename T>
void add_arithmetic(nb::class_<T>& type, const char* zero) {
  type.def("__add__", [](const T& a, const T& b) { return a + b; }, nb::is_operator(), nb::arg("other"),
           "Return the sum.")
      .def("__sub__", [](const T& a, const T& b) { return a - b; }, nb::is_operator(), nb::arg("other"),
           "Return the difference.")
      .def("__iadd__", [](T& a, const T& b) -> T& { return a = a + b; }, nb::is_operator(), nb::arg("other"),
           nb::rv_policy::none, "Add in place.")
      .def("__isub__", [](T& a, const T& b) -> T& { return a = a - b; }, nb::is_operator(), nb::arg("other"),
           nb::rv_policy::none, "Subtract in place.")
      .def("__mul__", [](const T& a, double s) { return s * a; }, nb::is_operator(), nb::arg("factor"),
           "Return the product with a number.")
      .def("__rmul__", [](const T& a, double s) { return s * a; }, nb::is_operator(), nb::arg("factor"),
           "Return the product with a number.")
      .def("__truediv__", [](const T& a, double s) { return a / s; }, nb::is_operator(), nb::arg("divisor"),
           "Return the quotient by a number.")
      .def("__neg__", [](const T& a) { return -a; }, "Return the opposite.")
      .def("ReverseSign", [](T& a) { a = -a; }, "Reverse the sign of each number in place.")
      .def_static("Zero", [] { return T(); }, zero)
      .def("__getitem__", [](T& self, int index) { return component(self, index); }, nb::arg("index"),
           "Return one number; raises IndexError.")
      .def("__setitem__", [](T& self, int index, double value) { component(self, index) = value; }, nb::arg("index"),
           nb::arg("value"), "Set one number; raises IndexError.")
      .def("__iter__", [](T& self) { return nb::iter(numbers(self)); },
           nb::sig("def __iter__(self) -> collections.abc.Iterator[float]"), "Return an iterator over the numbers.");
}

}  // namespace kdl_values

void bind_kdl_vector(nanobind::module_& m);
void bind_kdl_rotation(nanobind::module_& m);
void bind_kdl_motion(nanobind::module_& m);
void bind_kdl_frame(nanobind::module_& m);
void bind_kdl_functions(nanobind::module_& m);

}  // namespace tfloom::bindings
