#include "dds/feeder.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace tfloom::dds {

namespace {

constexpr std::chrono::seconds max_wait_for_work(1);  // at the end, as long as the other wires wait

}  // namespace

Feeder::Feeder() : state_(std::make_shared<State>()), thread_([state = state_] { state->run(); }) {}

Feeder::~Feeder() { stop(); }

void Feeder::stop() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->scheduled.notify_one();
  if (!thread_.joinable()) return;
  if (thread_.get_id() == std::this_thread::get_id() || !wait_for_end()) {
    thread_.detach();
  } else {
    thread_.join();
  }
}

bool Feeder::wait_for_end() {
  std::unique_lock lock(state_->mutex);
  if (state_->advanced.wait_for(lock, max_wait_for_work, [&] { return state_->has_ended; })) return true;
  // A drain runs no function of the program's, and uses what is deleted next: wait for its end, however late. No other one
  // begins.
  state_->advanced.wait(lock, [&] { return state_->draining == nullptr; });
  return state_->has_ended;
}

void Feeder::schedule(Task& task) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->enqueue(task);
  }
  state_->scheduled.notify_one();  // after the lock is released, because the woken thread would wait for it
}

void Feeder::defer(Work work) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->deferred.push_back(std::move(work));
  }
  state_->scheduled.notify_one();
}

void Feeder::cancel(Task& task) {
  std::unique_lock lock(state_->mutex);
  state_->advanced.wait(lock, [&] { return state_->draining != &task; });
  std::erase(state_->waiting, &task);
}

void Feeder::State::enqueue(Task& task) {
  if (std::ranges::find(waiting, &task) != waiting.end()) return;
  waiting.push_back(&task);
}

void Feeder::State::run() {
  std::unique_lock lock(mutex);
  for (;;) {
    scheduled.wait(lock, [&] { return stopping || !waiting.empty() || !deferred.empty(); });
    // Deferred work comes first, and is done even when the feeder stops; tasks are not drained then.
    if (!deferred.empty()) {
      Work work = std::move(deferred.front());
      deferred.pop_front();
      lock.unlock();
      work();
      work = nullptr;  // destroys what it captured, without the lock
      lock.lock();
      continue;
    }
    if (stopping) break;
    // `draining` lets `cancel` wait for this task; a task with more to drain goes behind those that wait already.
    Task* task = draining = waiting.front();
    waiting.pop_front();
    lock.unlock();
    const bool more = task->drain_();
    lock.lock();
    draining = nullptr;
    if (more) enqueue(*task);
    advanced.notify_all();
  }
  has_ended = true;
  advanced.notify_all();
}

}  // namespace tfloom::dds
