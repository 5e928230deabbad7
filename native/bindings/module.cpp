#include "bindings/bindings.hpp"

NB_MODULE(_native, m) {
  m.doc() = "The compiled core of tfloom: numbers, ids and bytes.";
  tfloom::bindings::bind_core(m);
  tfloom::bindings::bind_dds(m);
}
