// One thread that takes data off readers, so that no listener of the DDS library ever does.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace tfloom::dds {

class Feeder {
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
  ~Feeder();
  Feeder(const Feeder&) = delete;
  Feeder& operator=(const Feeder&) = delete;

  // Has `source` drained soon. From any thread, a listener's too: it never waits for a drain.
  void schedule(Source& source);

  // When this returns, `source` isn't being drained and won't be until it is scheduled again.
  void forget(Source& source);

  // Ends the thread; what is scheduled is left. Not from the feeder's own thread.
  void stop();

 private:
  void run();
  void enqueue(Source& source);

  std::mutex mutex_;
  std::condition_variable scheduled_;
  std::condition_variable drained_;
  std::deque<Source*> waiting_;
  Source* draining_ = nullptr;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace tfloom::dds
