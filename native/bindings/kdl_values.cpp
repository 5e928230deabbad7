// Components, texts and pickled states of the classes of KDL.
#include <nanobind/nanobind.h>

#include <concepts>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "bindings/bindings.hpp"
#include "bindings/kdl.hpp"

namespace tfloom::bindings::kdl_values {
namespace {

using kdl::Frame;
using kdl::Rotation;
using kdl::Twist;
using kdl::Wrench;
using tf2::Vector3;

template <kdl::Screw T>
constexpr const char* name_of = std::same_as<T, Twist> ? "Twist" : "Wrench";

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

void expect(const nb::tuple& numbers, std::size_t size, const char* name) {
  if (nb::len(numbers) == size) return;
  throw nb::value_error((std::string("the pickled state is not one of a ") + name).c_str());
}

}  // namespace

double& component(Vector3& v, int i) {
  if (i < 0 || i > 2) throw nb::index_error("Vector index out of range");
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
template <kdl::Screw T>
double& component(T& screw, int i) {
  auto& [first, second] = screw;
  if (i < 0 || i > 5) throw nb::index_error((std::string(name_of<T>) + " index out of range").c_str());
  return component(i < 3 ? first : second, i % 3);
}

std::string text(const Vector3& v) { return listed({v.x, v.y, v.z}); }
std::string text(const Rotation& r) {
  const auto& m = r.m;
  return listed({m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]}, 3);
}
std::string text(const Frame& f) {
  std::string result = "[";
  return result.append(text(f.M)).append(1, '\n').append(text(f.p)).append(1, ']');
}
template <kdl::Screw T>
std::string text(const T& screw) {
  const auto& [a, b] = screw;
  return listed({a.x, a.y, a.z, b.x, b.y, b.z});
}

nb::tuple numbers(const Vector3& v) { return nb::make_tuple(v.x, v.y, v.z); }
template <kdl::Screw T>
nb::tuple numbers(const T& screw) {
  const auto& [a, b] = screw;
  return nb::make_tuple(a.x, a.y, a.z, b.x, b.y, b.z);
}

nb::tuple state(const Vector3& v) { return numbers(v); }
nb::tuple state(const Rotation& r) {
  const auto& m = r.m;
  return nb::make_tuple(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
}
nb::tuple state(const Frame& f) { return nb::make_tuple(f.M, f.p); }
template <kdl::Screw T>
nb::tuple state(const T& screw) {
  const auto& [first, second] = screw;
  return nb::make_tuple(first, second);
}

void restore(Vector3& v, const nb::tuple& parts) {
  expect(parts, 3, "Vector");
  v = {nb::cast<double>(parts[0]), nb::cast<double>(parts[1]), nb::cast<double>(parts[2])};
}
void restore(Rotation& r, const nb::tuple& parts) {
  if (nb::len(parts) == 3) {  // roll, pitch and yaw, as Orocos' PyKDL stores it
    r = Rotation::of_rpy(nb::cast<double>(parts[0]), nb::cast<double>(parts[1]), nb::cast<double>(parts[2]));
    return;
  }
  expect(parts, 9, "Rotation");
  for (std::size_t i = 0; i < 9; ++i) r.m[i] = nb::cast<double>(parts[i]);
}
void restore(Frame& f, const nb::tuple& parts) {
  expect(parts, 2, "Frame");
  f = {nb::cast<Rotation>(parts[0]), nb::cast<Vector3>(parts[1])};
}
template <kdl::Screw T>
void restore(T& screw, const nb::tuple& parts) {
  expect(parts, 2, name_of<T>);
  screw = {nb::cast<Vector3>(parts[0]), nb::cast<Vector3>(parts[1])};
}

template double& component(Twist& t, int i);
template double& component(Wrench& w, int i);
template std::string text(const Twist& t);
template std::string text(const Wrench& w);
template nb::tuple numbers(const Twist& t);
template nb::tuple numbers(const Wrench& w);
template nb::tuple state(const Twist& t);
template nb::tuple state(const Wrench& w);
template void restore(Twist& t, const nb::tuple& parts);
template void restore(Wrench& w, const nb::tuple& parts);

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
