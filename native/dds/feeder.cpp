#include "dds/feeder.hpp"

#include <algorithm>
#include <utility>

namespace tfloom::dds {

Feeder::Feeder() : thread_(&Feeder::run, this) {}

Feeder::~Feeder() { stop(); }

void Feeder::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  scheduled_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Feeder::schedule(Source& source) {
  {
    const std::lock_guard lock(mutex_);
    enqueue(source);
  }
  scheduled_.notify_one();  // after the lock is released, because the woken thread would wait for it
}

void Feeder::defer(Work work) {
  {
    const std::lock_guard lock(mutex_);
    deferred_.push_back(std::move(work));
  }
  scheduled_.notify_one();
}

void Feeder::cancel(Source& source) {
  std::unique_lock lock(mutex_);
  drained_.wait(lock, [&] { return draining_ != &source; });
  std::erase(waiting_, &source);
}

void Feeder::enqueue(Source& source) {
  if (std::ranges::find(waiting_, &source) != waiting_.end()) return;
  waiting_.push_back(&source);
}

void Feeder::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    scheduled_.wait(lock, [&] { return stopping_ || !waiting_.empty() || !deferred_.empty(); });
    if (!deferred_.empty()) {
      Work work = std::move(deferred_.front());
      deferred_.pop_front();
      lock.unlock();
      work();
      work = nullptr;  // destroys what it captured, without the lock
      lock.lock();
      continue;
    }
    if (stopping_) return;
    Source* source = draining_ = waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    const bool more = source->drain();
    lock.lock();
    draining_ = nullptr;
    if (more) enqueue(*source);
    drained_.notify_all();
  }
}

}  // namespace tfloom::dds
