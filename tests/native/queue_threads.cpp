// Threads that post, wait, feed and cancel at once, as a wire's listeners, executors and readers do. Returns 0 if no
// sample was lost, none was drained after its source had been cancelled, and all deferred work was run; the sanitizer
// checks the rest.
#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "checks.hpp"
#include "core/ready_queue.hpp"
#include "core/sample_queue.hpp"
#include "dds/feeder.hpp"

using tfloom::DeferredQueue;
using tfloom::ReadyQueue;
using tfloom::SampleQueue;
using tfloom::dds::Feeder;

namespace {

constexpr int samples = 20'000;
constexpr int lives = 300;
constexpr int acts = 5'000;

// As a reader does: what comes is counted, and drained a few at a time into a sink that posts.
class Reader {
 public:
  Reader(Feeder& feeder, SampleQueue& sink, ReadyQueue& queue) : feeder_(feeder), sink_(sink), queue_(queue) {}
  ~Reader() {
    feeder_.cancel(drain_task_);
    is_gone_ = true;
  }

  void receive() {
    ++waiting_;
    feeder_.schedule(drain_task_);
  }

 private:
  bool drain() {
    check(!is_gone_, "a source was drained after it had been cancelled");
    for (int i = 0; i < 3; ++i) {
      if (waiting_ == 0) return false;
      --waiting_;
      const std::byte data[5]{};
      sink_.push(data, {});
      queue_.post(sink_.pushed() % 7);
    }
    return waiting_ > 0;
  }

  Feeder& feeder_;
  SampleQueue& sink_;
  ReadyQueue& queue_;
  std::atomic<int> waiting_{0};
  std::atomic<bool> is_gone_{false};
  Feeder::Task drain_task_{[this] { return drain(); }};
};

// One thread pushes into a sink; another waits for the sink's tokens, and detaches and attaches as executors do.
void check_sink() {
  const auto queue = std::make_shared<ReadyQueue>();
  SampleQueue sink(1);
  std::thread wire([&] {
    const std::byte data[5]{};
    for (int i = 0; i < samples; ++i) sink.push(data, {});
  });
  std::vector<ReadyQueue::Token> tokens;
  std::uint64_t seen = 0;
  for (ReadyQueue::Token token = 1; seen < samples; ++token) {
    sink.notify(queue, token);
    for (int spins = 0; spins < 5 && seen < samples; ++spins) {
      const auto outcome = queue->wait(10'000'000'000, tokens, true);
      check(outcome == ReadyQueue::Outcome::ready, "a push woke no thread");
      if (outcome != ReadyQueue::Outcome::ready) seen = samples;
      for (const auto taken : tokens) check(taken == token, "a token came after it had been withdrawn");
      if (sink.take_pushed()) seen = std::max(seen, sink.pushed());
    }
    sink.notify(nullptr, 0);
  }
  wire.join();
}

// A feeder ends though its work does not return; the thread then does the rest of it.
void check_stuck_work() {
  const auto is_open = std::make_shared<std::atomic<bool>>(false), is_done = std::make_shared<std::atomic<bool>>(false);
  {
    Feeder feeder;
    feeder.defer([is_open] { is_open->wait(false); });
    feeder.defer([is_done] {
      *is_done = true;
      is_done->notify_all();
    });
  }
  check(!*is_done, "work was done before the one that was deferred earlier");
  *is_open = true;
  is_open->notify_all();
  is_done->wait(false);
}

}  // namespace

int main() {
  check_sink();
  check_stuck_work();
  Feeder feeder;
  ReadyQueue queue;
  SampleQueue sink(10);
  SampleQueue other_sink(10);
  Reader reader(feeder, sink, queue);

  std::vector<std::thread> threads;
  for (int t = 0; t < 2; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < samples; ++i) reader.receive();
    });
  }
  threads.emplace_back([&] {
    for (int i = 0; i < lives; ++i) {
      Reader brief(feeder, other_sink, queue);
      for (int k = 0; k < 10; ++k) brief.receive();
    }
  });
  std::atomic<int> acts_run{0};
  for (int t = 0; t < 2; ++t) {
    threads.emplace_back([&] {
      const DeferredQueue::Scope scope(feeder);
      const auto before = std::make_shared<std::atomic<int>>(0);
      for (int i = 0; i < acts; ++i) {
        DeferredQueue::current()->defer([&acts_run, before, i] {
          check(DeferredQueue::current() == nullptr, "deferred work was to be deferred again");
          check(before->exchange(i + 1) == i, "deferred work ran out of order");
          ++acts_run;
        });
      }
    });
  }
  std::vector<ReadyQueue::Token> tokens;
  while (sink.pushed() < 2 * samples) {
    const auto outcome = queue.wait(10'000'000'000, tokens);
    check(outcome == ReadyQueue::Outcome::ready, "a post woke nobody");
    if (outcome != ReadyQueue::Outcome::ready) break;
    for (const auto token : tokens) check(token < 7, "a token that nobody posted");
    static_cast<void>(sink.take());
  }
  for (auto& thread : threads) thread.join();
  check(sink.pushed() == 2 * samples, "samples were lost or came twice");
  feeder.stop();
  check(acts_run == 2 * acts, "some deferred work was never run");
  return faults == 0 ? 0 : 1;
}
