// The one thing an executor waits for: a queue of tokens of entities that have something to do.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_set>
#include <vector>

#include "core/waker.hpp"

namespace tfloom {

// Any thread posts; one thread waits. A token posted again before it is taken is taken once.
class ReadyQueue {
 public:
  using Token = std::uint64_t;
  enum class Outcome { ready, timeout, interrupted };

  void post(Token token);

  // Moves all posted tokens, in order of first posting, into `tokens`. Waits for the first one: not at all with
  // a timeout of 0, for ever with a negative one. `interrupted`: a signal handler ran on this thread.
  Outcome wait(std::int64_t timeout_ns, std::vector<Token>& tokens);

 private:
  bool take(std::vector<Token>& tokens);

  std::mutex mutex_;
  std::vector<Token> order_;  // guarded by mutex_, as are the next two
  std::unordered_set<Token> pending_;
  bool is_waiting_ = false;  // the thread that waits found nothing, and hasn't been woken since
  Waker waker_;              // for any thread by itself
};

}  // namespace tfloom
