// Releases the GIL for a scope, also in threads that outlive the interpreter.
//
// When Python ends, it ends each daemon thread that acquires the GIL by unwinding its stack, which calls
// std::terminate, because the frames below a binding are noexcept. So from the end on, no thread acquires it.
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
