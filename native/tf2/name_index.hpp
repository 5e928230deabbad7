// A hash table from frame names to ids, with open addressing in one contiguous array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

namespace tfloom::tf2 {

// The names are stored by the caller, and name_of(id) returns them. With std::unordered_map, a transform of a whole
// robot's /tf takes 15 % longer: benchmarks/native, "name index".
class NameIndex {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  template <class NameOf>
  [[nodiscard]] std::uint32_t find(std::string_view name, NameOf&& name_of) const {
    const std::uint32_t hash = hash_of(name);
    for (std::size_t i = hash & mask();; i = (i + 1) & mask()) {
      const Slot& slot = slots_[i];
      if (slot.id == none) return none;
      if (slot.hash == hash && name_of(slot.id) == name) return slot.id;
    }
  }

  // Return the first id with the hash of `name`, without comparing names. Another name may have the same hash.
  [[nodiscard]] std::uint32_t find_by_hash(std::string_view name) const {
    const std::uint32_t hash = hash_of(name);
    for (std::size_t i = hash & mask();; i = (i + 1) & mask()) {
      if (slots_[i].id == none || slots_[i].hash == hash) return slots_[i].id;
    }
  }

  // Add a name that is not in the table.
  void add(std::string_view name, std::uint32_t id) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    place({hash_of(name), id});
    ++count_;
  }

  void clear() {
    slots_.assign(least, {});
    count_ = 0;
  }

 private:
  static constexpr std::size_t least = 16;
  struct Slot {
    std::uint32_t hash = 0, id = none;
  };

  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }

  void place(Slot slot) {
    std::size_t i = slot.hash & mask();
    while (slots_[i].id != none) i = (i + 1) & mask();
    slots_[i] = slot;
  }

  void grow() {
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    for (const Slot& slot : old) {
      if (slot.id != none) place(slot);
    }
  }

  // Random for each process, because names come from the wire and a sender could otherwise choose names that collide.
  static std::uint64_t seed() {
    static const std::uint64_t value = (std::uint64_t{std::random_device{}()} << 32) | std::random_device{}();
    return value;
  }

  [[nodiscard]] std::uint32_t hash_of(std::string_view name) const {
    const char* const text = name.data();
    const std::size_t size = name.size();
    std::uint64_t hash = seed_ ^ size;
    const auto take = [&hash](std::uint64_t bytes) {
      hash = (hash ^ bytes) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    };
    if (size >= 8) {
      for (std::size_t at = 0; at + 8 < size; at += 8) take(read(text + at, 8));
      take(read(text + size - 8, 8));  // overlaps
    } else {
      take(read(text, size));
    }
    return static_cast<std::uint32_t>((hash * 0xbf58476d1ce4e5b9u) >> 32);
  }

  static std::uint64_t read(const char* text, std::size_t size) {
    std::uint64_t bytes = 0;
    if (size >= 8) {
      std::memcpy(&bytes, text, 8);
    } else if (size >= 4) {
      std::uint32_t first = 0, last = 0;  // overlap
      std::memcpy(&first, text, 4);
      std::memcpy(&last, text + size - 4, 4);
      bytes = (std::uint64_t{first} << 32) | last;
    } else {
      for (std::size_t i = 0; i < size; ++i) bytes = (bytes << 8) | static_cast<unsigned char>(text[i]);
    }
    return bytes;
  }

  std::uint64_t seed_ = seed();
  std::vector<Slot> slots_ = std::vector<Slot>(least);
  std::size_t count_ = 0;
};

}  // namespace tfloom::tf2
