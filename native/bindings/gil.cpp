#include "bindings/gil.hpp"

#include <atomic>
#include <chrono>
#include <thread>
#ifndef _WIN32
#include <pthread.h>
#endif
#if defined(__GLIBC__) && PY_VERSION_HEX < 0x030E0000
#define TFLOOM_THREADS_ARE_UNWOUND
#include <dlfcn.h>
#include <link.h>

#include "core/imports.hpp"
#endif

namespace tfloom::bindings {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds max_wait(1);  // for callbacks that run when the interpreter ends

enum class Phase { running, ending };
std::atomic<Phase> phase{Phase::running};
std::thread::id ending_thread;  // written once, before `phase`, and read after it
std::atomic<int> users{0};      // how often threads are acquiring the GIL by an AcquiredGil, or have done so
thread_local int depth = 0;     // of the AcquiredGil scopes of this thread

bool is_finalizing() {
#if PY_VERSION_HEX >= 0x030D0000
  return Py_IsFinalizing() != 0;
#else
  return _Py_IsFinalizing() != 0;
#endif
}

// Return whether the interpreter ends on another thread.
bool is_ending() { return phase == Phase::ending && std::this_thread::get_id() != ending_thread; }

// Count this thread as a user, unless the interpreter is ending on another thread: return false then. The count precedes
// the check, so that either this thread sees the end, or the ending thread sees the count and waits: check and
// acquisition are one step.
//
// A thread inside an AcquiredGil goes on until the interpreter's state is torn down: the ending thread may wait for it, not
// only in `block_waits_at_exit`, but also when it closes a wire whose thread runs a callback.
bool enter() {
  ++users;
  if (!is_ending() || (depth > 0 && !is_finalizing())) return true;
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

#ifdef TFLOOM_THREADS_ARE_UNWOUND
// Called by Python instead of pthread_exit, on a thread that does not have the GIL.
[[noreturn]] void exit_thread(void*) { block_forever(); }

// Where this fails, as in a Python that does not import pthread_exit, threads are unwound as before.
void block_threads_in_place_of_their_exit() {
  Dl_info info;
  void* library = nullptr;
  const auto* address = reinterpret_cast<const void*>(&PyThread_exit_thread);
  if (dladdr1(address, &info, &library, RTLD_DL_LINKMAP) == 0 || library == nullptr) return;
  replace_import(*static_cast<const link_map*>(library), "pthread_exit", reinterpret_cast<void*>(&exit_thread));
}
#endif

}  // namespace

ReleasedGil::ReleasedGil() : state_(PyEval_SaveThread()) {}

// Python up to 3.13 would end this thread in PyEval_RestoreThread, while the stack has frames of C++: block it before.
ReleasedGil::~ReleasedGil() {
  if (is_ending() && is_finalizing()) block_forever();
  PyEval_RestoreThread(state_);
}

GilReleasedForWait::~GilReleasedForWait() {
  if (is_ending() && depth == 0) block_forever();
}

AcquiredGil::AcquiredGil() {
  if (has_gil()) {
    use_ = Use::held_before;
    return;
  }
  if (!enter()) return;
  // Counted from here on: the ending thread waits until this scope has ended.
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
  --users;  // last, because the ending thread goes on as soon as the count is 0
}

void block_waits_at_exit() {
  if (phase != Phase::running) return;
#ifdef TFLOOM_THREADS_ARE_UNWOUND
  block_threads_in_place_of_their_exit();
#endif
  // The thread is stored before the phase, because other threads read the phase first.
  ending_thread = std::this_thread::get_id();
  phase = Phase::ending;
  // Threads that counted themselves before still acquire the GIL, and run callbacks to their end. Wait for them, because
  // Python would end these threads at their next line.
  PyThreadState* state = PyEval_SaveThread();
  const auto deadline = Clock::now() + max_wait;
  while (users != 0 && Clock::now() < deadline) std::this_thread::sleep_for(std::chrono::microseconds(100));
  PyEval_RestoreThread(state);
}

void block_if_ending() {
  if (!is_ending() || depth > 0) return;
  PyEval_SaveThread();
  block_forever();
}

void count_threads_anew_in_forks() {
#ifndef _WIN32
  // The other threads do not exist in the child, so they would never be counted down.
  pthread_atfork(nullptr, nullptr, [] { users = depth; });
#endif
}

}  // namespace tfloom::bindings
