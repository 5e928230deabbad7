// Lets go of the interpreter for a scope, also in threads that outlive it.
//
// When Python ends, it ends each daemon thread that asks for the interpreter by unwinding its stack, and C++ answers
// that with std::terminate: the frames below a binding are noexcept. So from the end on, nobody asks.
#pragma once

#include <Python.h>

namespace tfloom::bindings {

class ReleasedGil {
 public:
  ReleasedGil();
  ~ReleasedGil();
  ReleasedGil(const ReleasedGil&) = delete;
  ReleasedGil& operator=(const ReleasedGil&) = delete;

 private:
  PyThreadState* state_;
};

// To be called with the interpreter held, on the thread that ends it: every other thread that would come back from
// a ReleasedGil sleeps for ever instead.
void keep_other_threads_out();

}  // namespace tfloom::bindings
