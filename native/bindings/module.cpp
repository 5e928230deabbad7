#include "bindings/bindings.hpp"

NB_MODULE(_native, m) {
  m.doc() = "The compiled core of tfloom: numbers, ids and bytes.";
  nanobind::set_leak_warnings(false);  // message classes and their plans live as long as the interpreter
  tfloom::bindings::bind_core(m);
  tfloom::bindings::bind_dds(m);
  tfloom::bindings::bind_cdr(m);
  tfloom::bindings::bind_tf2(m);
}
