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
  // A member of what is drained. It must be cancelled before it is destroyed.
  class Source {
   public:
    // `drain` processes some of the pending data, on the feeder's thread, and returns true if there may be more.
    explicit Source(std::function<bool()> drain) : drain_(std::move(drain)) {}
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

   private:
    friend class Feeder;
    const std::function<bool()> drain_;
  };

  Feeder();
  ~Feeder() override;

  // Queue `source` to be drained. May be called from any thread, in a listener too: it returns before the drain.
  void schedule(Source& source);

  // Remove `source` from the queue and wait until a drain of it has ended. Afterwards it is not drained until it is
  // scheduled again.
  void cancel(Source& source);

  // Queue `work`. May be called in a listener, and with a lock held.
  void defer(Work work) override;

  // Run the deferred work and end the thread; sources that are still queued are not drained. Return when the thread has
  // ended; on the feeder's own thread, where deferred work may release what owns the feeder, return at once: the thread
  // then ends after the rest of the work.
  void stop();

 private:
  // Shared with the thread, which may outlive the feeder.
  struct State {
    std::mutex mutex;
    std::condition_variable scheduled;  // waits with mutex, like the next
    std::condition_variable drained;
    std::deque<Source*> waiting;  // sources to drain; guarded by mutex, like the next three
    std::deque<Work> deferred;
    Source* draining = nullptr;  // the source that is being drained
    bool stopping = false;

    void run();
    void enqueue(Source& source);  // requires mutex to be held
  };

  const std::shared_ptr<State> state_;
  std::thread thread_;  // started by the constructor; joined or detached by `stop`, which one thread calls
};

}  // namespace tfloom::dds
