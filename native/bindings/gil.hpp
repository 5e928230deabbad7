// Runs a stretch of C++ without the GIL, safely on daemon threads too.
#pragma once

#include <nanobind/nanobind.h>

#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

#include <chrono>
#include <thread>

namespace tfloom::bindings {

// As nanobind's gil_scoped_release, but for the end of the interpreter: up to Python 3.13 a thread that then asks for
// the GIL is ended by pthread_exit, which glibc does by unwinding the stack, and no C++ frame above may be unwound.
// Such a thread sleeps here instead, as it does from Python 3.14 on.
class ReleasedGil {
 public:
  ReleasedGil() : state_(PyEval_SaveThread()) {}
  ReleasedGil(const ReleasedGil&) = delete;
  ReleasedGil& operator=(const ReleasedGil&) = delete;
  ~ReleasedGil() {
#ifdef __GLIBCXX__
    try {
      PyEval_RestoreThread(state_);
    } catch (const abi::__forced_unwind&) {
      for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    }
#else
    PyEval_RestoreThread(state_);
#endif
  }

 private:
  PyThreadState* state_;
};

}  // namespace tfloom::bindings
