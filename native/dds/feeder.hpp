// A thread for work that may block, which the listeners of the DDS library must not do.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/deferred_queue.hpp"

namespace tfloom::dds {

class Feeder : public DeferredQueue {
 public:
  class Source {
   public:
    Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    virtual ~Source() = default;

    // Process some of the pending data, on the feeder's thread. Return true if there may be more.
    virtual bool drain() = 0;
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

  // Run the deferred work and end the thread; sources that are still queued are not drained. Must not be called on the
  // feeder's own thread.
  void stop();

 private:
  void run();
  void enqueue(Source& source);

  std::mutex mutex_;
  std::condition_variable scheduled_;  // waits with mutex_, like the next
  std::condition_variable drained_;
  std::deque<Source*> waiting_;  // sources to drain; guarded by mutex_, like the next three
  std::deque<Work> deferred_;
  Source* draining_ = nullptr;  // the source that is being drained
  bool stopping_ = false;
  std::thread thread_;  // started by the constructor, joined by `stop`
};

}  // namespace tfloom::dds
