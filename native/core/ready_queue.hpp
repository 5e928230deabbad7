// The queue on which an executor waits: tokens of entities that are ready.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_set>
#include <vector>

#include "core/busy_wait.hpp"
#include "core/waker.hpp"

namespace tfloom {

// Any thread may post; one thread waits. A token that is posted again before it is taken is taken once.
//
// What posts to a queue shares it, for as long as it posts to it: a queue that waits no more is freed, with its
// descriptor, though the endpoints to which it was given live on.
class ReadyQueue : public std::enable_shared_from_this<ReadyQueue> {
 public:
  using Shared = std::shared_ptr<ReadyQueue>;
  using Token = std::uint64_t;
  enum class Outcome { ready, timeout, interrupted };

  void post(Token token);

  // Post a token for waits with `quiet` only; other waits neither wake nor take it.
  void post_quietly(Token token);

  // Remove a token that was posted quietly, unless it was taken.
  void withdraw(Token token);

  // Move all posted tokens, in order of first posting, into `tokens`, and with `quiet` also those posted quietly. Return
  // false if there are none.
  bool take(std::vector<Token>& tokens, bool quiet = false);

  // Do as `take`; if there are none, wait for the first one: up to `timeout_ns`, or without limit if that is negative.
  // `interrupted`, `interrupt_fd`: see Waker::wait.
  Outcome wait(std::int64_t timeout_ns, std::vector<Token>& tokens, bool quiet = false, int interrupt_fd = -1);

 private:
  Outcome sleep(const Waker::Deadline& deadline, std::vector<Token>& tokens, bool quiet, int interrupt_fd);
  // As `take`. `will_sleep`: whether the next post must wake this thread, if there are no tokens.
  bool take(std::vector<Token>& tokens, bool quiet, bool will_sleep);

  std::mutex mutex_;
  std::vector<Token> order_;  // guarded by mutex_, like the next four
  std::unordered_set<Token> pending_;
  std::vector<Token> quiet_;      // posted quietly: few, one for each sink
  bool is_waiting_ = false;       // the waiting thread found no token, and has not been woken since
  bool is_quiet_wanted_ = false;  // whether that wait, or the last one, takes quiet tokens
  std::atomic<bool> has_tokens_ = false;  // whether a wait would end; written under mutex_, read in a busy wait
  Waker waker_;                           // thread-safe by itself
  BusyWait busy_wait_;                    // of the waiting thread alone
};

}  // namespace tfloom
