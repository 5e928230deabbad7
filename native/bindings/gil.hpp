// Release or acquire the GIL for a scope, also in threads that outlive the interpreter.
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

// Acquire the GIL for a scope, on any thread. The conversion to bool is false if there is no GIL to acquire, because the
// interpreter is ending on another thread or has ended: then Python must not be used.
class AcquiredGil {
 public:
  AcquiredGil();
  ~AcquiredGil();
  AcquiredGil(const AcquiredGil&) = delete;
  AcquiredGil& operator=(const AcquiredGil&) = delete;

  explicit operator bool() const { return use_ != Use::none; }

 private:
  enum class Use { none, held_before, acquired };
  Use use_ = Use::none;
  PyGILState_STATE state_{};
};

// A scope, with the GIL held, in which native code runs Python code, which may give up the GIL and acquire it again at any
// line: an import does so for many milliseconds. The interpreter's end waits for it, as for an AcquiredGil; after that it
// blocks its thread for ever, because Python would unwind the native frames with it.
class PythonCallScope {
 public:
  PythonCallScope();
  ~PythonCallScope();
  PythonCallScope(const PythonCallScope&) = delete;
  PythonCallScope& operator=(const PythonCallScope&) = delete;
};

// A class whose `close` waits for other threads, as Python holds it: its destructor closes it without the GIL, because
// those threads may wait for the GIL. A class with virtual functions must not be derived from like this: other threads
// may call them while the constructor of the derived class replaces them.
template <class Closable>
class ClosedWithoutGil : public Closable {
 public:
  using Closable::Closable;
  ~ClosedWithoutGil() {
    const ReleasedGil released;
    this->close();
  }
};

// From now on, block every other thread for ever at the end of its ReleasedGil and at the start of its PythonCallScope, and
// let no other thread begin an AcquiredGil. Wait up to a second for the end of those that have begun. Must be called with
// the GIL held, on the thread that ends the interpreter.
void block_gil_reacquire_at_exit();

// From now on, a fork of this process counts only the thread that it has. Must be called once.
void count_threads_anew_in_forks();

}  // namespace tfloom::bindings
