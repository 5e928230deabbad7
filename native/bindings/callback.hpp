// A Python callable that C++ may copy, call and destroy on any thread. On a thread that must not wait for the GIL,
// calls and the release of the callable are deferred.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/deferred_queue.hpp"

namespace tfloom::bindings {

inline bool python_is_ending() {
#if PY_VERSION_HEX >= 0x030D0000
  return !Py_IsInitialized() || Py_IsFinalizing();
#else
  return !Py_IsInitialized() || _Py_IsFinalizing();
#endif
}

class Callback {
 public:
  explicit Callback(nanobind::callable callable)
      : callable_(callable.release().ptr(), [](PyObject* object) {
          if (DeferredQueue* queue = DeferredQueue::current()) {
            queue->defer([object] { release(object); });
          } else {
            release(object);
          }
        }) {}

  // An exception of the callable is reported as unraisable, because no Python caller could handle it.
  template <class... Args>
  void operator()(Args&&... args) const {
    if (DeferredQueue* queue = DeferredQueue::current()) {
      queue->defer([self = *this, kept = std::tuple<std::decay_t<Args>...>(std::forward<Args>(args)...)] {
        std::apply(self, kept);
      });
      return;
    }
    if (python_is_ending()) return;
    const nanobind::gil_scoped_acquire gil;
    const nanobind::handle callable(callable_.get());
    try {
      callable(std::forward<Args>(args)...);
    } catch (nanobind::python_error& error) {
      error.restore();
      PyErr_WriteUnraisable(callable.ptr());
    }
  }

 private:
  static void release(PyObject* object) {
    if (python_is_ending()) return;
    const nanobind::gil_scoped_acquire gil;
    Py_DECREF(object);
  }

  std::shared_ptr<PyObject> callable_;
};

}  // namespace tfloom::bindings
