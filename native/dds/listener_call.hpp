// A call of a listener, recorded.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "dds/abi.hpp"

namespace tfloom::dds {

// One call of a listener. If the status has another size, the arguments after it are elsewhere, so `self` is compared
// before it is used. `Tag` makes a type for each listener.
template <int Tag, typename Status>
struct ListenerCall {
  ListenerCall() {
    expected = this;
    is_misplaced = false;
  }
  ~ListenerCall() { expected = nullptr; }
  ListenerCall(const ListenerCall&) = delete;
  ListenerCall& operator=(const ListenerCall&) = delete;

  static void on_call(Entity entity, Status status, void* self) {
    if (self != expected) {
      is_misplaced = true;
      return;
    }
    auto& call = *static_cast<ListenerCall*>(self);
    call.entity = entity;
    call.status = status;
    call.has_come = true;
  }

  // Return whether it has come, to `listening` and with its own argument, within a second.
  [[nodiscard]] bool wait(Entity listening) const {
    for (int i = 0; i < 1000 && !has_come && !is_misplaced; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return has_come && !is_misplaced && entity == listening;
  }

  static inline std::atomic<ListenerCall*> expected = nullptr;
  static inline std::atomic<bool> is_misplaced = false;
  Entity entity = 0;
  Status status{};
  std::atomic<bool> has_come = false;
};

}  // namespace tfloom::dds
