#include "cdr/ahead_filter.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace tfloom::cdr {
namespace {

// Stamps on the wire are below 2.2e18 ns. With these bounds, no sum or difference below overflows.
constexpr tf2::Stamp max_now = 2'300'000'000'000'000'000;
constexpr tf2::Stamp max_reach = 4'000'000'000'000'000'000;
constexpr tf2::Stamp min_reach = 1'000'000'000;  // a shorter one would not bridge the time between two messages

}  // namespace

bool AheadFilter::Seen::is_no_further(const Seen& former, tf2::Stamp reach) const {
  return stamp - former.stamp <= reach || lead - former.lead <= reach;
}

bool AheadFilter::Seen::confirms(const Seen& held, tf2::Stamp reach) const {
  return stamp > held.stamp && (stamp - held.stamp <= reach || std::abs(lead - held.lead) <= reach);
}

void AheadFilter::Publisher::pass(const Seen& seen) {
  if (!newest || seen.stamp > newest->stamp) newest = seen;
}

void AheadFilter::Publisher::drop_held() {
  held.clear();
  newest_held.reset();
}

void AheadFilter::Publisher::drop_held(std::string_view child_frame_id) {
  if (!newest_held) return;
  std::erase_if(held, [&](const Held& transform) { return transform.child_frame_id == child_frame_id; });
  if (held.empty()) newest_held.reset();
}

void AheadFilter::Publisher::hold(const tf2::Entry& entry, const Seen& seen, tf2::Stamp reach) {
  const bool is_other = newest_held && std::abs(seen.stamp - newest_held->stamp) > reach;
  if (is_other || held.size() >= max_held) drop_held();
  std::erase_if(held, [&](const Held& transform) {
    return transform.stamp == entry.stamp && transform.child_frame_id == entry.child_frame_id;
  });
  if (entry.frame_id.size() <= max_name_size && entry.child_frame_id.size() <= max_name_size) {
    held.push_back({std::string(entry.frame_id), std::string(entry.child_frame_id), entry.stamp, entry.value});
  }
  if (!newest_held || seen.stamp > newest_held->stamp) newest_held = seen;
}

AheadFilter::Message AheadFilter::filter(std::vector<tf2::Entry>& entries, const Gid& gid, tf2::Stamp now,
                                         tf2::Stamp reach) {
  Message message;
  if (entries.empty()) return message;
  now = std::clamp(now, -max_now, max_now);
  reach = std::clamp(reach, min_reach, max_reach);
  const auto seen = [now](const tf2::Entry& entry) { return Seen{entry.stamp, entry.stamp - now}; };
  const auto& newest = *std::ranges::max_element(entries, {}, &tf2::Entry::stamp);
  Publisher& publisher = find(gid);
  // The usual message: nothing in it is far ahead, and nothing is held.
  if (newest.stamp - now <= reach && !publisher.newest_held) {
    publisher.pass(seen(newest));
    return message;
  }

  // If one of these transforms confirms those that are held, release them: the publisher's clock is ahead. That comes
  // before the test of the message's own transforms, which the released stamp may let pass.
  const auto confirms = [&](const tf2::Entry& entry) { return seen(entry).confirms(*publisher.newest_held, reach); };
  if (publisher.newest_held && std::ranges::any_of(entries, confirms)) {
    publisher.pass(*publisher.newest_held);
    message.released = std::move(publisher.held);
    publisher.drop_held();
  }
  // What is not like a transform that this publisher has sent before is held. One that is like a former one passes,
  // however far ahead it is: the former one was confirmed.
  const auto is_far_ahead = [&](const tf2::Entry& entry) {
    const Seen candidate = seen(entry);
    return candidate.lead > reach && !(publisher.newest && candidate.is_no_further(*publisher.newest, reach));
  };
  std::vector<tf2::Entry> passed;
  for (const tf2::Entry& entry : entries) {
    if (is_far_ahead(entry)) {
      publisher.hold(entry, seen(entry), reach);
      // One warning for each publisher is enough: all of them have the same cause, its clock.
      if (!std::exchange(publisher.is_reported, true)) {
        message.first_held = Held{std::string(entry.frame_id), std::string(entry.child_frame_id), entry.stamp, {}};
      }
    } else {
      passed.push_back(entry);
    }
  }
  // Only now, because one message's transforms are judged by former messages, and not by each other. A stamp that is not
  // far ahead shows that the one held for the same frame was wrong.
  for (const tf2::Entry& entry : passed) {
    publisher.pass(seen(entry));
    publisher.drop_held(entry.child_frame_id);
  }
  entries = std::move(passed);
  return message;
}

AheadFilter::Publisher& AheadFilter::find(const Gid& gid) {
  if (last_ != publishers_.end() && last_->first == gid) return last_->second;
  last_ = publishers_.find(gid);
  if (last_ == publishers_.end()) {
    if (publishers_.size() >= max_publishers) publishers_.clear();
    last_ = publishers_.try_emplace(gid).first;
  }
  return last_->second;
}

void AheadFilter::forget(const Gid& publisher) {
  publishers_.erase(publisher);
  last_ = publishers_.end();
}

void AheadFilter::clear() {
  publishers_.clear();
  last_ = publishers_.end();
}

std::size_t AheadFilter::held_count() const {
  std::size_t count = 0;
  for (const auto& [gid, publisher] : publishers_) count += publisher.held.size();
  return count;
}

}  // namespace tfloom::cdr
