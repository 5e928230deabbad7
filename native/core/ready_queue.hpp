// The queue on which an executor waits: tokens of entities that are ready.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_set>
#include <vector>

#include "core/waker.hpp"

namespace tfloom {

// Any thread may post; one thread waits. A token that is posted again before it is taken is taken once.
class ReadyQueue {
 public:
  using Token = std::uint64_t;
  enum class Outcome { ready, timeout, interrupted };

  void post(Token token);

  // Move all posted tokens, in order of first posting, into `tokens`. Return false if there are none.
  bool take(std::vector<Token>& tokens);

  // Move all posted tokens, in order of first posting, into `tokens`. If there are none, wait for the first one: up to
  // `timeout_ns`, or without limit if that is negative. `interrupted`, `interrupt_fd`: see Waker::wait.
  Outcome wait(std::int64_t timeout_ns, std::vector<Token>& tokens, int interrupt_fd = -1);

 private:
  std::mutex mutex_;
  std::vector<Token> order_;  // guarded by mutex_, like the next two
  std::unordered_set<Token> pending_;
  bool is_waiting_ = false;  // the waiting thread found no token, and has not been woken since
  Waker waker_;              // thread-safe by itself
};

}  // namespace tfloom
