// Senders of large datagrams wait until the sockets of receivers on this machine have room for them.
//
// On the loopback interface nothing slows a sender down: what a full socket can't hold, the kernel drops. The datagrams of
// one message of a megabyte are more than a socket of the default size holds.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "rtps/announcements.hpp"
#include "rtps/recent_map.hpp"

namespace tfloom::dds {

// What waits in a socket, and how much may, as the kernel counts it: more than the bytes of the datagrams [bytes].
struct SocketQueue {
  std::uint32_t used = 0;
  std::uint32_t limit = 0;
};

#ifdef __linux__
// Return what an answer of sock_diag(7) says of a socket; nullopt if it says nothing of one.
std::optional<SocketQueue> read_socket_queue(std::span<const std::byte> answer);
#endif

// How the kernel and the clock are asked; others in a test.
class FlowSources {
 public:
  using Clock = std::chrono::steady_clock;

  FlowSources() = default;
  FlowSources(const FlowSources&) = delete;
  FlowSources& operator=(const FlowSources&) = delete;
  virtual ~FlowSources() = default;

  // Return the queue of the socket that receives at an address; nullopt if it is not of this machine, or unknown. One
  // thread calls this at a time.
  virtual std::optional<SocketQueue> queue(const rtps::Address& receiver) = 0;
  [[nodiscard]] virtual Clock::time_point now() const { return Clock::now(); }
  virtual void sleep(std::chrono::microseconds time) const { std::this_thread::sleep_for(time); }

  static std::unique_ptr<FlowSources> of_system();
};

class FlowControl {
 public:
  explicit FlowControl(std::unique_ptr<FlowSources> sources) : sources_(std::move(sources)) {}

  // Return the object of this process; a forked child has a separate one.
  static FlowControl& of_process();

  // Wait until the socket at an address has room for a datagram, at most `patience` in which the receiver reads nothing.
  // Afterwards no datagram waits until it has read some: one that has stopped must not stop the sender. The wait ends after
  // `longest_wait` in any case, because nothing can interrupt it: others may fill the socket as fast as it is read. Then no
  // datagram waits until there was room. Return false, at once, if the queue is unknown. May be called by any thread.
  bool wait_for_room(const rtps::Address& receiver, std::size_t size);

  static constexpr std::chrono::milliseconds patience{50};
  static constexpr std::chrono::milliseconds longest_wait{1000};

 private:
  struct Flow {
    std::size_t room = 0;  // what fits without another question
    FlowSources::Clock::time_point asked{};
    bool is_known = false;
    bool is_given_up = false;     // until it has read some, or has room
    std::size_t given_up_at = 0;  // what waited in it at most since then; 0: room alone counts
  };

  // Return whether a datagram can be sent now; nullopt if the queue is unknown.
  std::optional<bool> has_room(const rtps::Address& receiver, std::size_t cost, std::size_t& used);
  void give_up(const rtps::Address& receiver, std::size_t used);

  const std::unique_ptr<FlowSources> sources_;
  std::mutex mutex_;  // held while the kernel is asked, never while a sender sleeps
  // Guarded by mutex_. Bounded, because anybody may announce addresses.
  rtps::RecentMap<rtps::Address, Flow> flows_{1024};
  bool is_answered_ = false;  // whether any queue was known
};

}  // namespace tfloom::dds
