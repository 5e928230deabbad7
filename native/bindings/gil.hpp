// Lets go of the interpreter for a scope, also in threads that outlive it.
//
// When Python ends, it ends each daemon thread that asks for the interpreter by unwinding its stack, and C++ answers
// that with std::terminate: the frames below a binding are noexcept. So from the end on, no thread asks.
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

// Block every other thread at the end of its ReleasedGil, for ever. Call it with the interpreter held, on the thread
// that ends it.
void block_gil_reacquire_at_exit();

}  // namespace tfloom::bindings
