// A descriptor that becomes readable when a signal arrives, for waits of the main thread.
//
// A signal that arrives between a check for signals and a system call that waits would otherwise end the wait only if
// another event does; so would one that the kernel delivers on another thread.
#pragma once

namespace tfloom::bindings {

// While it exists, Python's C handler of signals writes to `fd`. Must be created and destroyed with the GIL held. The
// descriptor of `signal.set_wakeup_fd` (asyncio has one) gets the same bytes at the end of the scope.
class SignalWakeup {
 public:
  SignalWakeup();
  ~SignalWakeup();
  SignalWakeup(const SignalWakeup&) = delete;
  SignalWakeup& operator=(const SignalWakeup&) = delete;

  // -1 on other threads than the main one, whose waits no signal ends, and on Windows.
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_ = -1;
  int former_fd_ = -1;  // to which Python wrote before
};

}  // namespace tfloom::bindings
