// KDL's vectors and rotations.
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
using kdl::Rotation;
using kdl::Twist;
using kdl::Wrench;
using tf2::Vector3;
using Cell = std::tuple<int, int>;
using Numbers = std::tuple<double, double, double>;

double& element(Rotation& r, const Cell& cell) {
  const auto [i, j] = cell;
  if (i < 0 || i > 2 || j < 0 || j > 2) throw nb::index_error("Rotation index out of range");
  return r.m[static_cast<std::size_t>(3 * i + j)];
}

Numbers numbers(const kdl::Angles& angles) { return {angles[0], angles[1], angles[2]}; }

template <std::size_t J>
Vector3 unit(const Rotation& r) {
  return r.column(J);
}
template <std::size_t J>
void set_unit(Rotation& r, const Vector3& vec) {
  r.set_column(J, vec);
}

template <double Vector3::* Part>
void add_part(nb::class_<Vector3>& type, const char* name) {
  type.def(name, [](Vector3& v, double value) { v.*Part = value; }, "value"_a, "Set the component.")
      .def(name, [](const Vector3& v) { return v.*Part; }, "Return the component.");
}

}  // namespace

void bind_kdl_vector(nb::module_& m) {
  auto type = kdl_values::value_class<Vector3>(m, "Vector", "KDL's vector of three numbers, which can be set.");
  type.def("__init__", [](Vector3* self, double x, double y, double z) { new (self) Vector3{x, y, z}; }, "x"_a, "y"_a,
           "z"_a, "Create one from its components.");
  add_part<&Vector3::x>(type, "x");
  add_part<&Vector3::y>(type, "y");
  add_part<&Vector3::z>(type, "z");
  kdl_values::add_arithmetic(type, "Return (0, 0, 0).");
  type.def("__mul__", [](const Vector3& a, const Vector3& b) { return cross(a, b); }, nb::is_operator(), "other"_a,
           "Return the cross product.")
      .def("Norm", &kdl::norm, "eps"_a = epsilon, "Return the length; 0 if no component reaches `eps`.")
      .def("Normalize", &kdl::normalize, "eps"_a = epsilon,
           "Divide by the length, and return it. A vector shorter than `eps` becomes (1, 0, 0), and 0 is returned.");
}

void bind_kdl_rotation(nb::module_& m) {
  auto type = kdl_values::value_class<Rotation>(
      m, "Rotation", "KDL's rotation, a matrix of 3 x 3 numbers, which can be set: `R[i, j]`. Angles in rad.");
  type.def("__init__",
           [](Rotation* self, double xx, double yx, double zx, double xy, double yy, double zy, double xz, double yz,
              double zz) { new (self) Rotation{{xx, yx, zx, xy, yy, zy, xz, yz, zz}}; },
           "xx"_a, "yx"_a, "zx"_a, "xy"_a, "yy"_a, "zy"_a, "xz"_a, "yz"_a, "zz"_a,
           "Create one from the matrix, row by row.")
      .def("__init__", [](Rotation* self, const Vector3& x, const Vector3& y,
                          const Vector3& z) { new (self) Rotation(Rotation::of_columns(x, y, z)); },
           "x"_a, "y"_a, "z"_a, "Create one from its columns.")
      .def_static("Identity", [] { return Rotation(); }, "Return the identity.")
      .def_static("RotX", &Rotation::about_x, "angle"_a, "Return a rotation about x.")
      .def_static("RotY", &Rotation::about_y, "angle"_a, "Return a rotation about y.")
      .def_static("RotZ", &Rotation::about_z, "angle"_a, "Return a rotation about z.")
      .def_static("Rot", &Rotation::about, "rotvec"_a, "angle"_a,
                  "Return a rotation about an axis of any length; about x, if it is shorter than 1e-6.")
      .def_static("Rot2", &Rotation::about_unit, "rotvec"_a, "angle"_a,
                  "Return a rotation about an axis of length one, which is not checked.")
      .def_static("RPY", &Rotation::of_rpy, "roll"_a, "pitch"_a, "yaw"_a,
                  "Return Rz(yaw) Ry(pitch) Rx(roll): about the fixed axes x, y and z, in this order.")
      .def_static("EulerZYX",
                  [](double alpha, double beta, double gamma) { return Rotation::of_rpy(gamma, beta, alpha); },
                  "alpha"_a, "beta"_a, "gamma"_a, "Return Rz(alpha) Ry(beta) Rx(gamma).")
      .def_static("EulerZYZ", &Rotation::of_euler_zyz, "alpha"_a, "beta"_a, "gamma"_a,
                  "Return Rz(alpha) Ry(beta) Rz(gamma).")
      .def_static("Quaternion",
                  [](double x, double y, double z, double w) { return Rotation::of_quaternion({x, y, z, w}); }, "x"_a,
                  "y"_a, "z"_a, "w"_a,
                  "Return the rotation of a unit quaternion. Another length scales the matrix by its square.")
      .def("GetRPY", [](const Rotation& r) { return numbers(r.rpy()); },
           "Return roll, pitch and yaw; roll is 0 where pitch is ±π/2.")
      .def("GetEulerZYX", [](const Rotation& r) {
        const auto [roll, pitch, yaw] = r.rpy();
        return Numbers(yaw, pitch, roll);
      }, "Return alpha, beta and gamma; gamma is 0 where beta is ±π/2.")
      .def("GetEulerZYZ", [](const Rotation& r) { return numbers(r.euler_zyz()); },
           "Return alpha, beta and gamma; gamma is 0 where beta is 0 or π.")
      .def("GetQuaternion", [](const Rotation& r) {
        const auto q = r.quaternion();
        return std::tuple(q.x, q.y, q.z, q.w);
      }, "Return x, y, z, w of the unit quaternion.")
      .def("GetRot", &kdl::rotation_vector, "Return the axis times the angle.")
      .def("GetRotAngle", [](const Rotation& r, double eps) {
        const auto [axis, angle] = kdl::axis_angle(r, eps);
        return std::tuple(angle, axis);
      }, "eps"_a = epsilon,
           "Return the angle from 0 to π, and the axis of length one; z at angle 0.\n\n"
           "A matrix that is symmetric within `eps` is one of 0 or π.")
      .def("DoRotX", [](Rotation& r, double angle) { r = r * Rotation::about_x(angle); }, "angle"_a,
           "Turn in place about the own x axis.")
      .def("DoRotY", [](Rotation& r, double angle) { r = r * Rotation::about_y(angle); }, "angle"_a,
           "Turn in place about the own y axis.")
      .def("DoRotZ", [](Rotation& r, double angle) { r = r * Rotation::about_z(angle); }, "angle"_a,
           "Turn in place about the own z axis.")
      .def("SetInverse", [](Rotation& r) { r = r.inverse(); }, "Invert in place.")
      .def("UnitX", &unit<0>, "Return the first column.")
      .def("UnitX", &set_unit<0>, "vec"_a, "Set the first column.")
      .def("UnitY", &unit<1>, "Return the second column.")
      .def("UnitY", &set_unit<1>, "vec"_a, "Set the second column.")
      .def("UnitZ", &unit<2>, "Return the third column.")
      .def("UnitZ", &set_unit<2>, "vec"_a, "Set the third column.")
      .def("__getitem__", [](Rotation& r, const Cell& cell) { return element(r, cell); }, "index"_a,
           "Return the number of a row and a column; raises IndexError.")
      .def("__setitem__", [](Rotation& r, const Cell& cell, double value) { element(r, cell) = value; }, "index"_a,
           "value"_a, "Set the number of a row and a column; raises IndexError.");
}

}  // namespace tfloom::bindings
