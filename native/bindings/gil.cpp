#include "bindings/gil.hpp"

#include <atomic>
#include <chrono>
#include <thread>
#ifndef _WIN32
#include <pthread.h>
#endif

namespace tfloom::bindings {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest_wait(1);  // for callbacks that run when the interpreter ends

enum class Phase { running, ending, ended };
std::atomic<Phase> phase{Phase::running};
std::thread::id ending_thread;  // written once, before `phase`, and read after it
std::atomic<int> users{0};      // how often threads are acquiring the GIL, or are inside one of the other two scopes
thread_local int depth = 0;     // of the AcquiredGil scopes and PythonCallScopes of this thread

// Count this thread as a user, unless the interpreter is ending on another thread: return false then. The count precedes
// the check, so that either this thread sees the end, or the ending thread sees the count and waits: check and
// acquisition are one step. A thread inside such a scope may still acquire the GIL while the ending thread waits for
// the end of that scope.
bool enter() {
  ++users;
  const Phase now = phase;
  if (now == Phase::running || std::this_thread::get_id() == ending_thread) return true;
  if (now == Phase::ending && depth > 0) return true;
  --users;
  return false;
}

// Return whether this thread has the GIL. True also while the thread ends the interpreter, when Py_IsInitialized is false
// and PyGILState_Ensure may abort; false after the end, when PyGILState_Check is true.
bool has_gil() {
#if PY_VERSION_HEX >= 0x030D0000
  const PyThreadState* state = PyThreadState_GetUnchecked();
#else
  const PyThreadState* state = _PyThreadState_UncheckedGet();
#endif
  return state != nullptr && PyGILState_Check() != 0;
}

[[noreturn]] void block_forever() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(24));
}

}  // namespace

ReleasedGil::ReleasedGil() : state_(PyEval_SaveThread()) {}

ReleasedGil::~ReleasedGil() {
  if (!enter()) block_forever();
  PyEval_RestoreThread(state_);
  --users;
}

AcquiredGil::AcquiredGil() {
  if (has_gil()) {
    use_ = Use::held_before;
    return;
  }
  if (!enter()) return;
  if (Py_IsInitialized() == 0) {  // a static destructor, after the interpreter's end
    --users;
    return;
  }
  state_ = PyGILState_Ensure();
  use_ = Use::acquired;
  ++depth;
}

AcquiredGil::~AcquiredGil() {
  if (use_ != Use::acquired) return;
  --depth;
  PyGILState_Release(state_);
  --users;
}

PythonCallScope::PythonCallScope() {
  if (!enter()) {
    PyEval_SaveThread();
    block_forever();
  }
  ++depth;
}

PythonCallScope::~PythonCallScope() {
  --depth;
  --users;
}

void block_gil_reacquire_at_exit() {
  ending_thread = std::this_thread::get_id();
  phase = Phase::ending;
  // Threads that counted themselves before still acquire the GIL, and run callbacks to their end. Wait for them, because
  // Python would end these threads at their next line.
  PyThreadState* state = PyEval_SaveThread();
  const auto deadline = Clock::now() + longest_wait;
  while (users != 0 && Clock::now() < deadline) std::this_thread::sleep_for(std::chrono::microseconds(100));
  phase = Phase::ended;
  PyEval_RestoreThread(state);
}

void count_threads_anew_in_forks() {
#ifndef _WIN32
  pthread_atfork(nullptr, nullptr, [] { users = depth; });
#endif
}

}  // namespace tfloom::bindings
