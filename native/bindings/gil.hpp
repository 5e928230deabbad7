// Release the GIL for a scope, also in threads that outlive the interpreter.
//
// When the interpreter ends, it unwinds the stack of each daemon thread that acquires the GIL. That calls
// std::terminate, because the stack frames below a binding are noexcept. So no other thread acquires the GIL at exit.
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

// From now on, block every other thread for ever at the end of its ReleasedGil. Must be called with the GIL held, on
// the thread that ends the interpreter.
void block_gil_reacquire_at_exit();

}  // namespace tfloom::bindings
