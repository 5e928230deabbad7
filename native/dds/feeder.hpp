// A thread for work that may block, which the listeners of the DDS library must not do.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "core/deferred_queue.hpp"

namespace tfloom::dds {

class Feeder : public DeferredQueue {
 public:
  // Pending data to drain: a member of what owns the data. It must be cancelled before it is destroyed.
  class Task {
   public:
    // `drain` processes some of the pending data, on the feeder's thread, and returns true if there may be more.
    explicit Task(std::function<bool()> drain) : drain_(std::move(drain)) {}
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

   private:
    friend class Feeder;
    const std::function<bool()> drain_;
  };

  Feeder();
  ~Feeder() override;

  // Queue `task` to be drained. May be called from any thread, in a listener too: it returns before the drain.
  void schedule(Task& task);

  // Remove `task` from the queue and wait until a drain of it has ended. Afterwards it is not drained until it is
  // scheduled again.
  void cancel(Task& task);

  // Queue `work`. May be called in a listener, and with a lock held.
  void defer(Work work) override;

  // Run the deferred work and end the thread; tasks that are still queued are not drained. Return when the thread has
  // ended, or after a second if deferred work takes longer: it may be a function of the program's that never returns. On
  // the feeder's own thread, where deferred work may release what owns the feeder, return at once. In both cases, the
  // thread ends after the rest of the work, and drains nothing.
  void stop();

 private:
  bool wait_for_end();  // of the thread, as `stop` does; false: it goes on

  // Shared with the thread, which may outlive the feeder.
  struct State {
    std::mutex mutex;
    std::condition_variable scheduled;  // waits with mutex, like the next
    std::condition_variable advanced;   // a drain or the thread has ended
    std::deque<Task*> waiting;  // tasks to drain; guarded by mutex, like the next three
    std::deque<Work> deferred;
    Task* draining = nullptr;  // the task that is being drained
    bool stopping = false;
    bool has_ended = false;

    void run();
    void enqueue(Task& task);  // requires mutex to be held
  };

  const std::shared_ptr<State> state_;
  std::thread thread_;  // started by the constructor; joined or detached by `stop`, which one thread calls
};

}  // namespace tfloom::dds
