#include "bindings/gil.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace tfloom::bindings {
namespace {

std::atomic<bool> ending{false};
std::thread::id ending_thread;  // written before `ending`
std::atomic<int> coming_back{0};

[[noreturn]] void sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(24));
}

}  // namespace

ReleasedGil::ReleasedGil() : state_(PyEval_SaveThread()) {}

ReleasedGil::~ReleasedGil() {
  ++coming_back;
  if (ending && std::this_thread::get_id() != ending_thread) {
    --coming_back;
    sleep_for_ever();
  }
  PyEval_RestoreThread(state_);
  --coming_back;
}

void block_gil_reacquire_at_exit() {
  ending_thread = std::this_thread::get_id();
  ending = true;
  // Those that asked before they could see it still get in, and must be in before the interpreter refuses them.
  PyThreadState* state = PyEval_SaveThread();
  while (coming_back != 0) std::this_thread::sleep_for(std::chrono::microseconds(100));
  PyEval_RestoreThread(state);
}

}  // namespace tfloom::bindings
