// Components, texts and pickled states of the classes of KDL.
#include <nanobind/nanobind.h>

#include <cstdio>
#include <initializer_list>

#include "bindings/bindings.hpp"
#include "bindings/kdl.hpp"

namespace tfloom::bindings::kdl_values {
namespace {

using kdl::Frame;
using kdl::Rotation;
using kdl::Twist;
using kdl::Wrench;
using tf2::Vector3;

double& of_two(Vector3& first, Vector3& second, int i, const char* error) {
  if (i < 0 || i > 5) throw nb::index_error(error);
  return component(i < 3 ? first : second, i % 3);
}

// In brackets, with the separators between them.
std::string listed(std::initializer_list<double> numbers, std::size_t in_row = 6) {
  std::string result;
  std::size_t i = 0;
  for (const double number : numbers) {
    char field[32];
    std::snprintf(field, sizeof field, "%s%12g", i == 0 ? "[" : i % in_row == 0 ? ";\n " : ",", number);
    result += field;
    ++i;
  }
  return result += ']';
}

std::string text(const Vector3& a, const Vector3& b) { return listed({a.x, a.y, a.z, b.x, b.y, b.z}); }

void expect(const nb::tuple& numbers, std::size_t size, const char* what) {
  if (nb::len(numbers) == size) return;
  throw nb::value_error((std::string("the pickled state is not one of ") + what).c_str());
}

void restore_two(Vector3& a, Vector3& b, const nb::tuple& parts, const char* what) {
  expect(parts, 2, what);
  a = nb::cast<Vector3>(parts[0]);
  b = nb::cast<Vector3>(parts[1]);
}

}  // namespace

double& component(Vector3& v, int i) {
  if (i < 0 || i > 2) throw nb::index_error("Vector index out of range");
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
double& component(Twist& t, int i) { return of_two(t.vel, t.rot, i, "Twist index out of range"); }
double& component(Wrench& w, int i) { return of_two(w.force, w.torque, i, "Wrench index out of range"); }

std::string text(const Vector3& v) { return listed({v.x, v.y, v.z}); }
std::string text(const Rotation& r) {
  const auto& m = r.m;
  return listed({m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]}, 3);
}
std::string text(const Frame& f) {
  std::string result = "[";
  return result.append(text(f.M)).append(1, '\n').append(text(f.p)).append(1, ']');
}
std::string text(const Twist& t) { return text(t.vel, t.rot); }
std::string text(const Wrench& w) { return text(w.force, w.torque); }

nb::tuple numbers(const Vector3& v) { return nb::make_tuple(v.x, v.y, v.z); }
nb::tuple numbers(const Twist& t) {
  return nb::make_tuple(t.vel.x, t.vel.y, t.vel.z, t.rot.x, t.rot.y, t.rot.z);
}
nb::tuple numbers(const Wrench& w) {
  return nb::make_tuple(w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z);
}

nb::tuple state(const Vector3& v) { return numbers(v); }
nb::tuple state(const Rotation& r) {
  const auto& m = r.m;
  return nb::make_tuple(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
}
nb::tuple state(const Frame& f) { return nb::make_tuple(f.M, f.p); }
nb::tuple state(const Twist& t) { return nb::make_tuple(t.vel, t.rot); }
nb::tuple state(const Wrench& w) { return nb::make_tuple(w.force, w.torque); }

void restore(Vector3& v, const nb::tuple& parts) {
  expect(parts, 3, "a Vector");
  v = {nb::cast<double>(parts[0]), nb::cast<double>(parts[1]), nb::cast<double>(parts[2])};
}
void restore(Rotation& r, const nb::tuple& parts) {
  if (nb::len(parts) == 3) {  // roll, pitch and yaw, as Orocos' PyKDL stores it
    r = Rotation::of_rpy(nb::cast<double>(parts[0]), nb::cast<double>(parts[1]), nb::cast<double>(parts[2]));
    return;
  }
  expect(parts, 9, "a Rotation");
  for (std::size_t i = 0; i < 9; ++i) r.m[i] = nb::cast<double>(parts[i]);
}
void restore(Frame& f, const nb::tuple& parts) {
  expect(parts, 2, "a Frame");
  f = {nb::cast<Rotation>(parts[0]), nb::cast<Vector3>(parts[1])};
}
void restore(Twist& t, const nb::tuple& parts) { restore_two(t.vel, t.rot, parts, "a Twist"); }
void restore(Wrench& w, const nb::tuple& parts) { restore_two(w.force, w.torque, parts, "a Wrench"); }

}  // namespace tfloom::bindings::kdl_values

namespace tfloom::bindings {

void bind_kdl(nanobind::module_& m) {
  bind_kdl_vector(m);
  bind_kdl_rotation(m);
  bind_kdl_motion(m);
  bind_kdl_frame(m);
  bind_kdl_functions(m);
}

}  // namespace tfloom::bindings
