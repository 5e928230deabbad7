// One thread for what the listeners of the DDS library must not do: whatever may wait.
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

    // Takes some of what waits, on the feeder's thread; true if there may be more.
    virtual bool drain() = 0;
  };

  Feeder();
  ~Feeder() override;

  // Has `source` drained soon. From any thread, a listener's too: it never waits for a drain.
  void schedule(Source& source);

  // When this returns, `source` isn't being drained and won't be until it is scheduled again.
  void forget(Source& source);

  // Runs `work` soon. Callers may be in a listener, or hold a lock.
  void defer(Work work) override;

  // Runs the deferred work, and ends the thread; sources that are scheduled are left. Not from the feeder's
  // own thread.
  void stop();

 private:
  void run();
  void enqueue(Source& source);

  std::mutex mutex_;
  std::condition_variable scheduled_;  // waits with mutex_, as does the next
  std::condition_variable drained_;
  std::deque<Source*> waiting_;  // guarded by mutex_, as are the next three
  std::deque<Work> deferred_;
  Source* draining_ = nullptr;
  bool stopping_ = false;
  std::thread thread_;  // started by the constructor, joined by `stop`
};

}  // namespace tfloom::dds
