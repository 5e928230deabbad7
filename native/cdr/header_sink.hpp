// Counts the frames in the headers of a topic's messages, by publisher.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sink.hpp"

namespace tfloom::cdr {

// For messages that begin with a std_msgs/msg/Header, of which nothing else is read. Thread-safe. Its memory is bounded:
// see the constants.
class HeaderSink final : public Sink {
 public:
  static constexpr std::size_t max_uses = 4096;
  static constexpr std::size_t max_name_size = 1024;  // [bytes]; a longer name counts as unreadable

  struct Use {
    Gid publisher{};
    std::string frame_id;
    std::uint64_t count = 0;
  };

  void push(std::span<const std::byte> data, const SampleInfo& info) noexcept override;

  [[nodiscard]] std::vector<Use> uses() const;  // in order of publishers and names
  [[nodiscard]] std::uint64_t unreadable_count() const;

 private:
  using Key = std::pair<Gid, std::string>;
  using View = std::pair<Gid, std::string_view>;
  struct Less {
    using is_transparent = void;
    template <class A, class B>
    bool operator()(const A& a, const B& b) const {
      return a.first < b.first || (a.first == b.first && std::string_view(a.second) < std::string_view(b.second));
    }
  };

  void add(const View& use);

  mutable std::mutex mutex_;  // guards all that follows
  std::map<Key, std::uint64_t, Less> counts_;
  std::uint64_t unreadable_ = 0;
};

}  // namespace tfloom::cdr
