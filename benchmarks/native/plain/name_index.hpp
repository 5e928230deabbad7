// Frame names and their ids in std::unordered_map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace tfloom::tf2 {

class NameIndex {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  template <class NameOf>
  [[nodiscard]] std::uint32_t find(std::string_view name, NameOf&&) const {
    return find_by_hash(name);
  }
  [[nodiscard]] std::uint32_t find_by_hash(std::string_view name) const {
    const auto found = ids_.find(name);
    return found == ids_.end() ? none : found->second;
  }
  void add(std::string_view name, std::uint32_t id) { ids_.emplace(name, id); }
  void clear() { ids_.clear(); }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
  };
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> ids_;
};

}  // namespace tfloom::tf2
