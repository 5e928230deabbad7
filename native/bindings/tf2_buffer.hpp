// The Python object of a buffer, for the files that bind parts of it.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "tf2/buffer.hpp"

namespace tfloom::bindings {

// Shares the buffer with sinks, which use it on other threads without Python.
struct BufferHandle {
  std::shared_ptr<tf2::Buffer> buffer;
};

void bind_tf2_transform(nanobind::module_& m);
void bind_tf2_batch(nanobind::module_& m, nanobind::class_<BufferHandle>& type);
void bind_tf2_messages(nanobind::class_<BufferHandle>& type);
void bind_tf2_frozen(nanobind::class_<BufferHandle>& type);
void bind_tf2_wire(nanobind::module_& m, nanobind::class_<BufferHandle>& type);
void bind_tf2_observer(nanobind::module_& m);

}  // namespace tfloom::bindings
