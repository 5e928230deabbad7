// The module tfloom._native, which consists of the families in bindings.hpp.

#include <cstdlib>

#include "bindings/bindings.hpp"

NB_MODULE(_native, m) {
  m.doc() = "The compiled core of tfloom: numbers, ids and bytes.";
  // Off by default, because a program may end while its daemon threads use objects. Tests of leaks switch them on.
  nanobind::set_leak_warnings(std::getenv("TFLOOM_LEAK_WARNINGS") != nullptr);
  tfloom::bindings::bind_core(m);
  tfloom::bindings::bind_dds(m);
  tfloom::bindings::bind_cdr(m);
  tfloom::bindings::bind_headers(m);
  tfloom::bindings::bind_tf2(m);
  tfloom::bindings::bind_bag(m);
  tfloom::bindings::bind_bag_reading(m);
  tfloom::bindings::bind_kdl(m);
  tfloom::bindings::bind_robot(m);
}
