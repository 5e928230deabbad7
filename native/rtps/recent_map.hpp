// A map of what others have sent, of bounded size.
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <optional>
#include <utility>

namespace tfloom::rtps {

// A map that gives up the entry that was not used for the longest time when it holds more than its bound. So senders that
// come in great numbers displace one another and those that are silent, and never one that goes on sending.
template <typename Key, typename Value>
class RecentMap {
 public:
  explicit RecentMap(std::size_t max_size) : max_size_(max_size) {}

  // Return the value of a key, as the last used one; create it if there is none. References to other values stay valid,
  // except to that of the entry that is dropped.
  Value& use(const Key& key) {
    const auto [entry, is_new] = entries_.try_emplace(key);
    if (is_new) {
      // First to the end of the list, then the removal: so the new entry itself is never the oldest.
      entry->second.place = uses_.insert(uses_.end(), key);
      if (entries_.size() > max_size_) take_oldest();
    } else {
      // Moves the node without a copy, so `place` remains valid.
      uses_.splice(uses_.end(), uses_, entry->second.place);
    }
    return entry->second.value;
  }

  // Return the value of a key, or nullptr; this does not count as a use.
  [[nodiscard]] Value* find(const Key& key) {
    const auto entry = entries_.find(key);
    return entry == entries_.end() ? nullptr : &entry->second.value;
  }
  [[nodiscard]] const Value* find(const Key& key) const {
    const auto entry = entries_.find(key);
    return entry == entries_.end() ? nullptr : &entry->second.value;
  }

  void erase(const Key& key) {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) return;
    uses_.erase(entry->second.place);
    entries_.erase(entry);
  }

  // Remove and return the entry that was not used for the longest time; nullopt if there is none.
  std::optional<std::pair<Key, Value>> take_oldest() {
    if (uses_.empty()) return std::nullopt;
    const auto entry = entries_.find(uses_.front());
    std::pair<Key, Value> oldest(entry->first, std::move(entry->second.value));
    uses_.pop_front();
    entries_.erase(entry);
    return oldest;
  }

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool is_full() const { return size() >= max_size_; }

  // Remove each entry of which `is_over(key, value)` is true.
  template <typename Predicate>
  void erase_if(Predicate is_over) {
    erase_if(entries_.begin(), entries_.end(), is_over);
  }

  // The same, of the keys in [first, last].
  template <typename Predicate>
  void erase_range_if(const Key& first, const Key& last, Predicate is_over) {
    erase_if(entries_.lower_bound(first), entries_.upper_bound(last), is_over);
  }

 private:
  struct Entry {
    Value value{};
    typename std::list<Key>::iterator place{};  // in uses_
  };

  template <typename Iterator, typename Predicate>
  void erase_if(Iterator entry, Iterator end, Predicate& is_over) {
    while (entry != end) {
      if (is_over(entry->first, entry->second.value)) {
        uses_.erase(entry->second.place);
        entry = entries_.erase(entry);
      } else {
        ++entry;
      }
    }
  }

  std::size_t max_size_;
  std::map<Key, Entry> entries_;
  // The last used one at the end. It has a copy of each key, because what entries_ holds can't hold its iterators.
  std::list<Key> uses_;
};

}  // namespace tfloom::rtps
