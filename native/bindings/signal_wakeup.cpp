#include "bindings/signal_wakeup.hpp"

#include <nanobind/nanobind.h>

#ifdef _WIN32

namespace tfloom::bindings {

SignalWakeup::SignalWakeup() = default;
SignalWakeup::~SignalWakeup() = default;

}  // namespace tfloom::bindings

#else

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif

namespace tfloom::bindings {
namespace {

// The pipe of this process. Used by the main thread only, so it needs no lock.
struct Pipe {
  pid_t process = 0;  // that opened it, because a fork must not read its parent's signals; 0: none
  int read_fd = -1, write_fd = -1;
};
Pipe current;

bool is_main_thread() {
#ifdef __linux__
  return syscall(SYS_gettid) == getpid();
#else
  return pthread_main_np() != 0;
#endif
}

// Return the pipe of this process; without descriptors if the process may open no more.
const Pipe& open_pipe() {
  if (current.process == getpid()) return current;
  if (current.process != 0) {
    close(current.read_fd);
    close(current.write_fd);
  }
  current = {};
  int ends[2];
  if (pipe(ends) != 0) return current;
  for (const int fd : ends) {
    fcntl(fd, F_SETFD, FD_CLOEXEC);
    fcntl(fd, F_SETFL, O_NONBLOCK);
  }
  current = {getpid(), ends[0], ends[1]};
  return current;
}

// Call `signal.set_wakeup_fd`, and return its result. Python's C function of this kind is not exported.
int set_wakeup_fd(int fd) {
  namespace nb = nanobind;
  static PyObject* const function = nb::object(nb::module_::import_("_signal").attr("set_wakeup_fd")).release().ptr();
  return nb::cast<int>(nb::handle(function)(fd, nb::arg("warn_on_full_buffer") = false));
}

// Empty the pipe into `to`, if that is a descriptor.
void drain(const Pipe& pipe, int to) {
  char signals[64];
  ssize_t count;
  while ((count = read(pipe.read_fd, signals, sizeof signals)) > 0) {
    if (to >= 0) static_cast<void>(!write(to, signals, static_cast<size_t>(count)));
  }
}

}  // namespace

SignalWakeup::SignalWakeup() {
  if (!is_main_thread()) return;
  const Pipe& pipe = open_pipe();
  if (pipe.process == 0) return;
  try {
    former_fd_ = set_wakeup_fd(pipe.write_fd);
    fd_ = pipe.read_fd;
  } catch (const nanobind::python_error&) {
    // An interpreter that was started on another thread takes that one for its main thread.
  }
}

SignalWakeup::~SignalWakeup() {
  if (fd_ < 0) return;
  try {
    set_wakeup_fd(former_fd_);
  } catch (nanobind::python_error& error) {
    error.discard_as_unraisable("the end of a wait");  // the former descriptor was closed meanwhile
  }
  // A wait inside a signal's handler is inside another scope, which still has to see the signals.
  if (former_fd_ != current.write_fd) drain(current, former_fd_);
}

}  // namespace tfloom::bindings

#endif
