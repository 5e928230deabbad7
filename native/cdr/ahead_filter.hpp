// Holds transforms that are stamped far ahead of now, until their publisher confirms that its clock is ahead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/sink.hpp"
#include "tf2/buffer.hpp"

namespace tfloom::cdr {

// One transform with a wrong stamp, far in the future, would be the newest of its frame for as long as it lasts: all
// later ones would be older than the history. A publisher whose clock is ahead, however, goes on to send such stamps.
// So a transform is far ahead if it is further ahead of now than `reach`, and its publisher has not sent one like it: a
// former one with a stamp at most `reach` before it, or one that was as far ahead when it came, within `reach`. It is
// held until a later message of the publisher has a greater stamp like it. It is dropped when the publisher's next one
// of that frame is not far ahead, or when another stamp far ahead takes its place.
//
// Not thread-safe. Its memory is bounded: see the constants.
class AheadFilter {
 public:
  AheadFilter() = default;
  AheadFilter(const AheadFilter&) = delete;  // because of last_
  AheadFilter& operator=(const AheadFilter&) = delete;

  struct Held {
    std::string frame_id;
    std::string child_frame_id;
    tf2::Stamp stamp = 0;
    tf2::Transform value;
  };

  struct Message {
    std::vector<Held> released;  // to be stored before what is left in `entries`
    std::optional<Held> first_held;  // set only at the first one of a publisher, for a warning
  };

  // Remove the entries that are far ahead from `entries`, which are those of one message of `publisher`.
  [[nodiscard]] Message filter(std::vector<tf2::Entry>& entries, const Gid& publisher, tf2::Stamp now,
                               tf2::Stamp reach);

  void forget(const Gid& publisher);
  void clear();

  [[nodiscard]] std::size_t publisher_count() const { return publishers_.size(); }
  [[nodiscard]] std::size_t held_count() const;

 private:
  static constexpr std::size_t max_publishers = 256;  // then all are forgotten
  static constexpr std::size_t max_held = 128;        // of a publisher; then all of it are dropped
  static constexpr std::size_t max_name_size = 256;   // a transform with a longer name is dropped, not held

  // A stamp, and how far it was ahead of now when it was received.
  struct Seen {
    tf2::Stamp stamp = 0;
    tf2::Stamp lead = 0;

    [[nodiscard]] bool is_no_further(const Seen& former, tf2::Stamp reach) const;
    [[nodiscard]] bool confirms(const Seen& held, tf2::Stamp reach) const;
  };

  struct Publisher {
    std::optional<Seen> newest;       // the newest one that was passed on
    std::optional<Seen> newest_held;  // set if one is held, or dropped for the length of its name
    std::vector<Held> held;
    bool is_reported = false;

    void pass(const Seen& seen);
    void hold(const tf2::Entry& entry, const Seen& seen, tf2::Stamp reach);
    void drop_held();
    void drop_held(std::string_view child_frame_id);
  };

  Publisher& find(const Gid& gid);

  std::map<Gid, Publisher> publishers_;
  std::map<Gid, Publisher>::iterator last_ = publishers_.end();  // most messages are from the publisher of the last one
};

}  // namespace tfloom::cdr
