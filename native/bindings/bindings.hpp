// The families of bindings, one file each; module.cpp adds them to tfloom._native.
#pragma once

#include <nanobind/nanobind.h>

namespace tfloom::bindings {

void bind_core(nanobind::module_& m);
void bind_dds(nanobind::module_& m);
void bind_cdr(nanobind::module_& m);
void bind_headers(nanobind::module_& m);
void bind_tf2(nanobind::module_& m);
void bind_bag(nanobind::module_& m);
void bind_bag_reading(nanobind::module_& m);
void bind_kdl(nanobind::module_& m);
void bind_robot(nanobind::module_& m);

}  // namespace tfloom::bindings
