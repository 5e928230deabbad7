// A Python callable that C++ may copy, call and destroy on any thread. On a thread that must not wait for the GIL,
// calls and the release of the callable are deferred.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include "bindings/gil.hpp"
#include "core/deferred_queue.hpp"

namespace tfloom::bindings {

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

  // An exception of the callable is reported as unraisable, because no Python caller could handle it. Once the
  // interpreter is ending, the call does nothing.
  template <class... Args>
  void operator()(Args&&... args) const {
    if (DeferredQueue* queue = DeferredQueue::current()) {
      queue->defer([self = *this, kept = std::tuple<std::decay_t<Args>...>(std::forward<Args>(args)...)] {
        std::apply(self, kept);
      });
      return;
    }
    const AcquiredGil gil;
    if (!gil) return;
    const nanobind::handle callable(callable_.get());
    try {
      callable(std::forward<Args>(args)...);
    } catch (nanobind::python_error& error) {
      error.restore();
      PyErr_WriteUnraisable(callable.ptr());
    }
  }

  // Visit the callable for the garbage collector, on behalf of the object that holds this callback. While a copy waits
  // for its call, the callable is not visited: the collector then takes it, and all that it refers to, for reachable.
  int traverse(visitproc visit, void* argument) const {
    return callable_.use_count() == 1 ? visit(callable_.get(), argument) : 0;
  }

 private:
  static void release(PyObject* object) {
    const AcquiredGil gil;
    if (gil) Py_DECREF(object);
  }

  std::shared_ptr<PyObject> callable_;  // one reference of Python's, shared by all copies
};

}  // namespace tfloom::bindings
