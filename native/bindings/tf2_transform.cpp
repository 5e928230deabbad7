// The value type of one rigid transform.
#include <nanobind/nanobind.h>
#include <nanobind/operators.h>
#include <nanobind/stl/array.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bindings/tf2_buffer.hpp"
#include "tf2/transform.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using tf2::Quaternion;
using tf2::Transform;
using tf2::Vector3;
using Triple = std::array<double, 3>;
using Quadruple = std::array<double, 4>;

Transform make(const Triple& p, const Quadruple& q) {
  const Quaternion rotation = tf2::canonical({q[0], q[1], q[2], q[3]});
  if (!(std::abs(dot(rotation, rotation) - 1.0) < 1e-6)) {
    throw nb::value_error("rotation_xyzw has no direction: it's zero, or not finite");
  }
  return {{p[0], p[1], p[2]}, rotation};
}

// Fixed axes x, y, z in this order: Rz(yaw) · Ry(pitch) · Rx(roll).
Transform from_rpy(double roll, double pitch, double yaw, const Triple& p) {
  const double cr = std::cos(roll / 2), sr = std::sin(roll / 2), cp = std::cos(pitch / 2), sp = std::sin(pitch / 2),
               cy = std::cos(yaw / 2), sy = std::sin(yaw / 2);
  return make(p, {sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
                  cr * cp * cy + sr * sp * sy});
}

double wrapped(double angle) {  // to (-π, π]
  if (angle > std::numbers::pi) return angle - 2 * std::numbers::pi;
  return angle <= -std::numbers::pi ? angle + 2 * std::numbers::pi : angle;
}

// Computed from half the sum and half the difference of yaw and roll (E. Bernardes and S. Viollet, "Quaternion to Euler
// angles conversion", 2022). Unlike the asin of a matrix element, this loses no digits near ±π/2.
nb::tuple rpy(const Transform& t) {
  const Quaternion& q = t.rotation;
  const double down = std::hypot(q.w + q.y, q.z - q.x), up = std::hypot(q.w - q.y, q.z + q.x);
  const double half_sum = std::atan2(q.z + q.x, q.w - q.y), half_difference = std::atan2(q.z - q.x, q.w + q.y);
  constexpr double locked = 1e-12;  // gimbal lock: yaw and roll turn about the same axis, so yaw is set to 0
  constexpr double right_angle = std::numbers::pi / 2;
  if (up < locked) return nb::make_tuple(wrapped(-2 * half_difference), right_angle, 0.0);
  if (down < locked) return nb::make_tuple(wrapped(2 * half_sum), -right_angle, 0.0);
  return nb::make_tuple(wrapped(half_sum - half_difference), 2 * std::atan2(down, up) - right_angle,
                        wrapped(half_sum + half_difference));
}

Transform from_axis_angle(const Triple& axis, double angle, const Triple& p) {
  const double norm = std::hypot(axis[0], axis[1], axis[2]);
  if (norm == 0.0 && angle == 0.0) return make(p, {0, 0, 0, 1});
  if (!(norm > 0.0)) throw nb::value_error("axis has no direction: it's zero, or not finite");
  const double s = std::sin(angle / 2) / norm;
  return make(p, {axis[0] * s, axis[1] * s, axis[2] * s, std::cos(angle / 2)});
}

nb::tuple axis_angle(const Transform& t) {
  const Quaternion q = t.rotation.w < 0.0 ? -t.rotation : t.rotation;
  const double sine = std::hypot(q.x, q.y, q.z);
  if (sine == 0.0) return nb::make_tuple(nb::make_tuple(1.0, 0.0, 0.0), 0.0);
  return nb::make_tuple(nb::make_tuple(q.x / sine, q.y / sine, q.z / sine), 2.0 * std::atan2(sine, q.w));
}

nb::tuple translation(const Transform& t) {
  return nb::make_tuple(t.translation.x, t.translation.y, t.translation.z);
}
nb::tuple rotation(const Transform& t) {
  return nb::make_tuple(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w);
}

nb::list rows(const Transform& t) {
  const auto m = tf2::rotation_matrix(t.rotation);
  const double p[3] = {t.translation.x, t.translation.y, t.translation.z};
  nb::list result;
  for (std::size_t i = 0; i < 3; ++i) result.append(nb::make_tuple(m[3 * i], m[3 * i + 1], m[3 * i + 2], p[i]));
  result.append(nb::make_tuple(0.0, 0.0, 0.0, 1.0));
  return result;
}

nb::object numpy() { return nb::module_::import_("numpy"); }

Transform from_matrix(const nb::object& matrix) {
  const nb::object array = numpy().attr("asarray")(matrix, "dtype"_a = "float64");
  const auto shape = nb::cast<nb::tuple>(array.attr("shape"));
  const bool is_matrix = nb::len(shape) == 2 && nb::cast<int>(shape[1]) == 4 &&
                         (nb::cast<int>(shape[0]) == 4 || nb::cast<int>(shape[0]) == 3);
  if (!is_matrix) throw nb::value_error("a matrix must be of shape (4, 4) or (3, 4)");
  std::array<double, 9> m{};
  Triple p{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[3 * i + j] = nb::cast<double>(array.attr("item")(i, j));
    p[i] = nb::cast<double>(array.attr("item")(i, 3));
  }
  // The columns must be orthonormal and right-handed; rounding errors within the tolerance are removed.
  constexpr double tolerance = 1e-4;
  const Vector3 x{m[0], m[3], m[6]}, y{m[1], m[4], m[7]}, z{m[2], m[5], m[8]};
  const auto near = [](const Vector3& a, const Vector3& b) {
    const Vector3 d = a - b;
    return std::abs(d.x) < tolerance && std::abs(d.y) < tolerance && std::abs(d.z) < tolerance;
  };
  const double length = std::hypot(x.x, x.y, x.z), other = std::hypot(y.x, y.y, y.z);
  if (!(std::abs(length - 1) < tolerance && std::abs(other - 1) < tolerance) || !near(cross(x, y), z)) {
    throw nb::value_error("the matrix is no rotation: its columns must be orthonormal and right-handed");
  }
  const Quaternion q = tf2::quaternion_of_matrix(m);
  return make(p, {q.x, q.y, q.z, q.w});
}

nb::object to_scipy(const Transform& t) {
  return nb::module_::import_("scipy.spatial.transform").attr("Rotation").attr("from_quat")(rotation(t));
}

Transform from_scipy(const nb::object& rotation, const Triple& p) {
  return make(p, nb::cast<Quadruple>(rotation.attr("as_quat")().attr("tolist")()));
}

nb::tuple apply(const Transform& t, const Triple& p) {
  const Vector3 moved = rotate(t.rotation, {p[0], p[1], p[2]}) + t.translation;
  return nb::make_tuple(moved.x, moved.y, moved.z);
}

}  // namespace

void bind_tf2_transform(nb::module_& m) {
  nb::class_<Transform>(m, "Transform",
                        "A rigid transform, immutable: parent_from_child takes points of the child into the parent.\n\n"
                        "`a_from_c = a_from_b @ b_from_c`: neighbours cancel.")
      .def("__init__", [](Transform* self, const Triple& p, const Quadruple& q) { new (self) Transform(make(p, q)); },
           "translation"_a = nb::make_tuple(0.0, 0.0, 0.0),
           "rotation_xyzw"_a = nb::make_tuple(0.0, 0.0, 0.0, 1.0),
           nb::sig("def __init__(self, translation: collections.abc.Sequence[float] = (0.0, 0.0, 0.0), "
                   "rotation_xyzw: collections.abc.Sequence[float] = (0.0, 0.0, 0.0, 1.0)) -> None"),
           "Create one from a position [m] and a quaternion of any length.\n\n"
           "Raises ValueError if the quaternion is zero or not finite.")
      .def_static("from_rpy", &from_rpy, "roll_rad"_a, "pitch_rad"_a, "yaw_rad"_a,
                  "translation"_a = nb::make_tuple(0.0, 0.0, 0.0),
                  "Create one from rotations about the fixed axes x, then y, then z [rad].")
      .def_static("from_axis_angle", &from_axis_angle, "axis"_a, "angle_rad"_a,
                  "translation"_a = nb::make_tuple(0.0, 0.0, 0.0),
                  "Create one from a rotation about `axis`, of any length, by `angle_rad`.\n\n"
                  "Raises ValueError if the axis is zero, unless the angle is zero too.")
      .def_static("from_matrix", &from_matrix, "matrix"_a,
                  "Create one from a matrix (4, 4) or (3, 4); raises ValueError if it is not a rigid transform.")
      .def_static("from_scipy", &from_scipy, "rotation"_a, "translation"_a = nb::make_tuple(0.0, 0.0, 0.0),
                  "Create one from a `scipy.spatial.transform.Rotation` and a position [m].")
      .def_prop_ro("translation", &translation, nb::sig("def translation(self) -> tuple[float, float, float]"),
                   "Position of the child's origin in the parent [m].")
      .def_prop_ro("rotation_xyzw", &rotation, nb::sig("def rotation_xyzw(self) -> tuple[float, float, float, float]"),
                   "Unit quaternion x, y, z, w.")
      .def_prop_ro("rpy_rad", &rpy, nb::sig("def rpy_rad(self) -> tuple[float, float, float]"),
                   "Roll, pitch, yaw about the fixed axes x, y, z [rad]; yaw is 0 where pitch is ±π/2.")
      .def_prop_ro("axis_angle", &axis_angle,
                   nb::sig("def axis_angle(self) -> tuple[tuple[float, float, float], float]"),
                   "Unit axis, and angle from 0 to π [rad].")
      .def("rows", &rows, nb::sig("def rows(self) -> list[tuple[float, float, float, float]]"),
           "Return the four rows of the matrix, without numpy.")
      .def("matrix", [](const Transform& t) { return numpy().attr("array")(rows(t)); },
           nb::sig("def matrix(self) -> numpy.typing.NDArray[numpy.float64]"),
           "Return the matrix (4, 4), float64.")
      .def("to_scipy", &to_scipy, nb::sig("def to_scipy(self) -> typing.Any"),
           "Return the rotation as a `scipy.spatial.transform.Rotation`.")
      .def("inverse", [](const Transform& t) { return inverse(t); }, "Return child_from_parent.")
      .def("interpolate", &tf2::interpolate, "other"_a, "ratio"_a,
           "Return the transform between this (ratio 0) and `other` (1): position linearly, rotation by slerp.")
      .def("apply", &apply, "point"_a, nb::sig("def apply(self, point: collections.abc.Sequence[float]) -> "
                                               "tuple[float, float, float]"),
           "Return a point, given in the child, in the parent.")
      .def("__matmul__", [](const Transform& a, const Transform& b) { return a * b; }, nb::is_operator(), "other"_a,
           "Return the composition.")
      .def("__eq__", [](const Transform& a, const Transform& b) { return a == b; }, nb::is_operator(), "other"_a,
           nb::sig("def __eq__(self, other: object, /) -> bool"), "Return whether all numbers are equal.")
      .def("__hash__", [](const Transform& t) { return nb::hash(nb::make_tuple(translation(t), rotation(t))); },
           "Return a hash of the numbers.")
      .def("__reduce__",
           [](nb::handle self) {
             const auto& t = nb::cast<const Transform&>(self);
             return nb::make_tuple(self.type(), nb::make_tuple(translation(t), rotation(t)));
           },
           nb::sig("def __reduce__(self) -> tuple[object, ...]"), "Return the class and the arguments for pickle.")
      .def("__repr__", [](const Transform& t) {
        return nb::str("Transform(translation={}, rotation_xyzw={})").format(translation(t), rotation(t));
      }, "Return a call that creates an equal value.");
}

}  // namespace tfloom::bindings
