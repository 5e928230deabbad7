// Release or acquire the GIL for a scope, also in threads that outlive the interpreter.
//
// When the interpreter ends, Python up to 3.13 ends each other thread at its next acquisition of the GIL, by pthread_exit:
// at any line of Python code. On glibc that unwinds the stack, and a native frame which is noexcept, or which catches `...`
// and rethrows nothing, ends the process by a signal. There are such frames below most Python code: nanobind's around each
// binding, the slot functions of Python's own types, and those of the threads of C++. Python code runs in them wherever a
// binding imports numpy, compiles a plan, checks a field, calls `__float__` or a callback, or creates an object, because
// that may collect garbage, and so call any `__del__`. No scope in our frames helps, because nanobind's are inside and
// outside of them.
//
// So, once the interpreter ends, Python's own call of pthread_exit blocks its thread for ever, wherever it is, as Python
// does by itself from 3.14 on. musl, macOS and Windows end a thread without unwinding it. The threads of C++ have ended
// before that, because the wires are closed at exit and wait for them; up to then they may acquire the GIL to finish what
// they have begun.
//
// While the functions of `atexit` run, a thread may hold a lock of Python's that they need, to close the wires. So it
// goes on until then, except at the end of a wait, where it holds no lock, and at the end of a spin: a daemon thread
// would otherwise raise an exception there, because its context has been closed.
//
// Python's functions for this are called here only: tests/architecture.py checks it.
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

// Release the GIL for the scope of a wait of which the caller holds no lock. When the interpreter ends on another thread,
// block for ever at the end of the wait, unless this thread is inside an AcquiredGil.
class GilReleasedForWait : public ReleasedGil {
 public:
  ~GilReleasedForWait();
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

// From now on, block every other thread for ever at the end of its GilReleasedForWait, let no other thread begin an
// AcquiredGil, and let Python block threads where it would end them. Wait up to a second for the end of each AcquiredGil
// that has begun; one that takes longer goes on. Calling it again does nothing. Must be called with the GIL held, on the
// thread that ends the interpreter.
void block_waits_at_exit();

// Block this thread for ever if the interpreter is ending on another thread, unless this one is inside an AcquiredGil. Must
// be called with the GIL held, where the caller holds no lock that closing a wire needs.
void block_if_ending();

// From now on, a fork of this process counts only the thread that it has. Must be called once.
void count_threads_anew_in_forks();

}  // namespace tfloom::bindings
