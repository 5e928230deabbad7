// One thread for what the listeners of the DDS library must not do: whatever may wait.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/later.hpp"

namespace tfloom::dds {

class Feeder : public Later {
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

  // Runs `act` soon. Callers may be in a listener, or hold a lock.
  void put_off(Act act) override;

  // Runs the acts that were put off, and ends the thread; sources that are scheduled are left. Not from the feeder's
  // own thread.
  void stop();

 private:
  void run();
  void enqueue(Source& source);

  std::mutex mutex_;
  std::condition_variable scheduled_;
  std::condition_variable drained_;
  std::deque<Source*> waiting_;
  std::deque<Act> acts_;
  Source* draining_ = nullptr;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tfloom::dds
