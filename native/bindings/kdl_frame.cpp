// KDL's twists, wrenches and frames, and its functions of all classes.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <tuple>

#include "bindings/kdl.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using kdl::epsilon;
using kdl::Frame;
using kdl::Rotation;
using kdl::Twist;
using kdl::Wrench;
using tf2::Vector3;
using Cell = std::tuple<int, int>;

double& element(Frame& f, const Cell& cell) {
  const auto [i, j] = cell;
  if (i < 0 || i > 2 || j < 0 || j > 3) throw nb::index_error("Frame index out of range");
  return j == 3 ? kdl_values::component(f.p, i) : f.M.m[static_cast<std::size_t>(3 * i + j)];
}

// `turned` in other axes, for a rotation or a frame.
template <typename By, typename T>
void add_change(nb::class_<By>& type) {
  type.def("__mul__", [](const By& by, const T& turned) { return by * turned; }, nb::is_operator(), "other"_a,
           "Return the product: the same in the parent's axes.")
      .def("Inverse", [](const By& by, const T& turned) { return by.inverse() * turned; }, "other"_a,
           "Return the product with the inverse: the same in the child's axes.");
}

template <typename By>
void add_changes(nb::class_<By>& type) {
  type.def("Inverse", [](const By& by) { return by.inverse(); }, "Return the inverse.")
      .def("__mul__", [](const By& a, const By& b) { return a * b; }, nb::is_operator(), "other"_a,
           "Return the composition.");
  add_change<By, Vector3>(type);
  add_change<By, Twist>(type);
  add_change<By, Wrench>(type);
}

// One of the vectors of a twist or a wrench.
template <kdl::Screw T>
struct Half {
  Vector3 T::* vector;
  const char* name;
  const char* setter;  // its signature
  const char* doc;
};

// The docstrings of what twists and wrenches have in common.
struct ScrewDocs {
  const char* create;
  const char* zero;
  const char* ref_point;
};

template <kdl::Screw T>
void bind_screw(nb::module_& m, const char* name, const char* doc, const Half<T>& first, const Half<T>& second,
                const ScrewDocs& docs) {
  auto type = kdl_values::value_class<T>(m, name, doc);
  type.def("__init__", [](T* self, const Vector3& a, const Vector3& b) { new (self) T{a, b}; }, nb::arg(first.name),
           nb::arg(second.name), docs.create);
  for (const Half<T>& half : {first, second}) {
    type.def_rw(half.name, half.vector, nb::for_setter(nb::sig(half.setter)), half.doc);
  }
  type.def("RefPoint", [](const T& screw, const Vector3& base) { return ref_point(screw, base); }, "base"_a,
           docs.ref_point);
  kdl_values::add_arithmetic(type, docs.zero);
}

template <typename T>
void add_comparison(nb::module_& m) {
  m.def("kdl_equal", [](const T& a, const T& b, double eps) { return kdl::equal(a, b, eps); }, "a"_a, "b"_a,
        "eps"_a = epsilon, "Return whether all numbers differ by less than `eps`.");
}

template <typename T, typename Velocity>
void add_differences(nb::module_& m) {
  m.def("kdl_diff", [](const T& a, const T& b, double dt) { return kdl::diff(a, b, dt); }, "a"_a, "b"_a, "dt"_a = 1.0,
        "Return the constant velocity from `a` to `b` in `dt` seconds, in the axes that both are given in.");
  m.def("kdl_add_delta", [](const T& a, const Velocity& da, double dt) { return kdl::add_delta(a, da, dt); }, "a"_a, "da"_a,
        "dt"_a = 1.0, "Return what `a` becomes in `dt` seconds with the velocity `da`: the reverse of `diff`.");
}

template <typename T>
void add_zero(nb::module_& m) {
  m.def("kdl_set_to_zero", [](T& value) { value = T(); }, "value"_a, "Set each number to zero.");
}

}  // namespace

void bind_kdl_motion(nb::module_& m) {
  bind_screw<Twist>(
      m, "Twist", "KDL's velocity of a body: `vel`, that of the point of reference, and `rot`, the angular one.",
      {&Twist::vel, "vel", "def vel(self, value: Vector) -> None", "Velocity of the point of reference [m/s]."},
      {&Twist::rot, "rot", "def rot(self, value: Vector) -> None", "Angular velocity [rad/s]."},
      {"Create one from both velocities.", "Return a twist of zeros.",
       "Return the same motion with the point of reference moved by `base`, in the same axes."});
  bind_screw<Wrench>(
      m, "Wrench", "KDL's load on a body: `force`, and `torque` about the point of reference.",
      {&Wrench::force, "force", "def force(self, value: Vector) -> None", "Force [N]."},
      {&Wrench::torque, "torque", "def torque(self, value: Vector) -> None",
       "Torque about the point of reference [Nm]."},
      {"Create one from force and torque.", "Return a wrench of zeros.",
       "Return the same load with the point of reference moved by `base`, in the same axes."});
  auto rotation = nb::borrow<nb::class_<Rotation>>(nb::type<Rotation>());
  add_changes(rotation);
}

void bind_kdl_frame(nb::module_& m) {
  auto type = kdl_values::value_class<Frame>(
      m, "Frame",
      "KDL's frame, parent_from_child: the rotation `M` and the origin `p`. `F * x` changes the axes of a vector, a "
      "twist, a wrench or a frame to the parent's, and their point of reference to the parent's origin.");
  type.def("__init__", [](Frame* self, const Rotation& r, const Vector3& v) { new (self) Frame{r, v}; }, "R"_a, "V"_a,
           "Create one from a rotation and an origin.")
      .def("__init__", [](Frame* self, const Vector3& v) { new (self) Frame{{}, v}; }, "V"_a,
           "Create one without a rotation.")
      .def("__init__", [](Frame* self, const Rotation& r) { new (self) Frame{r, {}}; }, "R"_a,
           "Create one at the parent's origin.")
      .def_rw("M", &Frame::M, nb::for_setter(nb::sig("def M(self, value: Rotation) -> None")),
              "The rotation.")
      .def_rw("p", &Frame::p, nb::for_setter(nb::sig("def p(self, value: Vector) -> None")),
              "The origin in the parent [m].")
      .def_static("Identity", [] { return Frame(); }, "Return the identity.")
      .def_static("DH", &Frame::dh, "a"_a, "alpha"_a, "d"_a, "theta"_a,
                  "Return the frame of Denavit and Hartenberg's parameters: Rz(theta) Tz(d) Tx(a) Rx(alpha).")
      .def_static("DH_Craig1989", &Frame::dh_craig, "a"_a, "alpha"_a, "d"_a, "theta"_a,
                  "Return the frame of the parameters as modified by Craig: Tx(a) Rx(alpha) Rz(theta) Tz(d).")
      .def("Integrate", &Frame::integrate, "twist"_a, "sample_frequency"_a,
           "Move in place by a twist in the own axes for `1 / sample_frequency` seconds.\n\n"
           "A rotation of less than 1e-6 is left out.")
      .def("__getitem__", [](Frame& f, const Cell& cell) { return element(f, cell); }, "index"_a,
           "Return the number of a row and a column, of which 3 is the origin's; raises IndexError.")
      .def("__setitem__", [](Frame& f, const Cell& cell, double value) { element(f, cell) = value; }, "index"_a,
           "value"_a, "Set the number of a row and a column; raises IndexError.");
  add_changes(type);
}

void bind_kdl_functions(nb::module_& m) {
  add_zero<Vector3>(m);
  add_zero<Wrench>(m);
  add_zero<Twist>(m);
  m.def("kdl_dot", [](const Vector3& a, const Vector3& b) { return kdl::dot(a, b); }, "a"_a, "b"_a,
        "Return the dot product.");
  m.def("kdl_dot", [](const Twist& a, const Wrench& b) { return kdl::dot(a, b); }, "a"_a, "b"_a, "Return the power.");
  m.def("kdl_dot", [](const Wrench& a, const Twist& b) { return kdl::dot(b, a); }, "a"_a, "b"_a, "Return the power.");
  add_comparison<Vector3>(m);
  add_comparison<Wrench>(m);
  add_comparison<Twist>(m);
  add_comparison<Rotation>(m);
  add_comparison<Frame>(m);
  add_differences<Vector3, Vector3>(m);
  add_differences<Rotation, Vector3>(m);
  add_differences<Frame, Twist>(m);
  add_differences<Twist, Twist>(m);
  add_differences<Wrench, Wrench>(m);
}

}  // namespace tfloom::bindings
