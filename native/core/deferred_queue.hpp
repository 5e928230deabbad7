// Calls into Python, deferred by a thread that must not wait for it; and the order in which locks are taken.
//
// A thread that holds one of these locks takes only locks further down:
//
//  1. Python's GIL. A thread that holds any lock below never asks for the GIL: calls into Python, and the release of
//     Python objects, come after the lock is released, or are deferred.
//  2. dds: Reader::lifecycle_mutex_; the mutexes of the open domains (participant.cpp) and libraries (library.cpp)
//  3. dds: Reader::feed_mutex_. A listener only tries it, and goes on without it.
//  4. dds: Graph::mutex_, Peers::mutex_, Events::taken_mutex_, Writer::in_use_: held while libddsc is called
//  5. libddsc's own locks, which it holds while it calls a listener
//  6. dds, taken by listeners: Reader::listener_mutex_, Events::mutex_, Feeder::mutex_
//  7. tf2: Requests::mutex_, then Buffer::frames_mutex_
//  8. with nothing taken below them: ReadyQueue::mutex_, SampleQueue::mutex_, Waker::mutex_ (Windows),
//     Buffer::waiting_mutex_, Log::mutex_
//
// Two locks of one number are not held together, except where the line says "then".
#pragma once

#include <functional>
#include <utility>

namespace tfloom {

class DeferredQueue {
 public:
  using Work = std::function<void()>;

  DeferredQueue() = default;
  DeferredQueue(const DeferredQueue&) = delete;
  DeferredQueue& operator=(const DeferredQueue&) = delete;
  virtual ~DeferredQueue() = default;

  // Run `work` soon, in order of arrival, on a thread that may wait. Return at once.
  virtual void defer(Work work) = 0;

  // The queue that takes this thread's calls into Python; nullptr: this thread may make them itself.
  static DeferredQueue* current() noexcept { return current_; }

  // While it lives, this thread's calls go to `queue`.
  class Scope {
   public:
    explicit Scope(DeferredQueue& queue) noexcept : before_(std::exchange(current_, &queue)) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { current_ = before_; }

   private:
    DeferredQueue* before_;
  };

 private:
  inline static thread_local DeferredQueue* current_ = nullptr;  // of each thread its own: no lock
};

}  // namespace tfloom
