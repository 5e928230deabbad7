#include "bindings/gil.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace tfloom::bindings {
namespace {

std::atomic<bool> ending{false};
std::thread::id ending_thread;  // written once, before `ending`, and read after it
std::atomic<int> reacquiring{0};

[[noreturn]] void block_forever() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(24));
}

}  // namespace

ReleasedGil::ReleasedGil() : state_(PyEval_SaveThread()) {}

ReleasedGil::~ReleasedGil() {
  ++reacquiring;
  if (ending && std::this_thread::get_id() != ending_thread) {
    --reacquiring;
    block_forever();
  }
  PyEval_RestoreThread(state_);
  --reacquiring;
}

void block_gil_reacquire_at_exit() {
  ending_thread = std::this_thread::get_id();
  ending = true;
  // Threads that counted themselves before `ending` was set still acquire the GIL. Wait for them, because they must
  // acquire it before the interpreter ends.
  PyThreadState* state = PyEval_SaveThread();
  while (reacquiring != 0) std::this_thread::sleep_for(std::chrono::microseconds(100));
  PyEval_RestoreThread(state);
}

}  // namespace tfloom::bindings
