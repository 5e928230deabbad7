// How a thread that must not wait for Python puts off what calls into it.
#pragma once

#include <functional>
#include <utility>

namespace tfloom {

class Later {
 public:
  using Act = std::function<void()>;

  Later() = default;
  Later(const Later&) = delete;
  Later& operator=(const Later&) = delete;
  virtual ~Later() = default;

  // Has `act` run soon, after those before it, on a thread that may wait. Never waits itself.
  virtual void put_off(Act act) = 0;

  // Whom this thread is to leave such acts to; nullptr: it may run them itself.
  static Later* of_this_thread() noexcept { return current_; }

  // While it lives, this thread leaves acts to `later`.
  class Scope {
   public:
    explicit Scope(Later& later) noexcept : before_(std::exchange(current_, &later)) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { current_ = before_; }

   private:
    Later* before_;
  };

 private:
  inline static thread_local Later* current_ = nullptr;
};

}  // namespace tfloom
