// A queue for calls into Python from threads that must not wait for the GIL. This file also defines the order of all
// locks.
//
// A thread that holds one of these locks acquires only locks with a higher number:
//
//  1. Python's GIL. A thread that holds any lock below never acquires the GIL: it calls into Python, and releases
//     Python objects, after it has released the lock, or defers both.
//  2. dds: Reader::lifecycle_mutex_; the mutexes of the open domains (participant.cpp) and libraries (library.cpp)
//  3. dds: Reader::feed_mutex_. A listener acquires it by try_lock only.
//  4. dds: Graph::mutex_, Peers::mutex_, Events::reported_mutex_, Writer::in_use_: held during calls of libddsc
//  5. libddsc's own locks, which it holds during calls of a listener
//  6. dds, acquired in listeners: Reader::listener_mutex_, Events::mutex_, the feeder's
//  7. core: Sink::mutex_; tf2: Requests::mutex_, then Buffer::frames_mutex_
//  8. no other lock is acquired below these: ReadyQueue::mutex_, SampleQueue::mutex_, Waker::mutex_ (Windows),
//     Buffer::waiting_mutex_, Log::mutex_, TfSink::mutex_,
//     StateTransforms::mutex_
//
// Two locks with the same number are not held together, except where the line says "then".
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

  // Queue `work` and return at once. It runs in order of arrival, on a thread that may block.
  virtual void defer(Work work) = 0;

  // Return the queue to which this thread defers its calls into Python; nullptr: this thread may make them itself.
  static DeferredQueue* current() noexcept { return current_; }

  // Make `queue` the current queue of this thread for the lifetime of the scope.
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
  inline static thread_local DeferredQueue* current_ = nullptr;  // thread_local: needs no lock
};

}  // namespace tfloom
