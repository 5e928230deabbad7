// Interned frame names, and what each frame has been told about its parent.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tf2/time_cache.hpp"

namespace tfloom::tf2 {

struct Frame {
  enum class Kind : std::uint8_t { root, fixed, moving };

  std::string name;
  std::string authority;  // who set it last
  Kind kind = Kind::root;
  FrameId fixed_parent = no_parent;
  Transform fixed_value;
  std::unique_ptr<TimeCache> history;  // of a moving frame

  // A static transform holds at any time; a frame that was never a child has no data at any.
  [[nodiscard]] Bracket find(Stamp stamp) const {
    if (kind == Kind::moving) return history->find(stamp);
    if (kind == Kind::root) return {};
    return {Bracket::Found::yes, fixed_parent, &fixed_value, nullptr, 0.0};
  }
  [[nodiscard]] FrameId newest_parent() const;
  [[nodiscard]] Stamp newest_stamp() const;  // 0: static, or no data
  [[nodiscard]] Stamp oldest_stamp() const;
  [[nodiscard]] std::size_t sample_count() const;

  // What was stored under the other kind is forgotten. False: too old.
  bool insert(const Sample& sample, bool is_static, Stamp max_age);

  void forget_parent(FrameId parent, Stamp max_age);
  void forget();  // all but the name: it's a root again
};

// Ids are dense, in order of registration; id 0 stands for "no parent" and has a name that nobody is to use.
class FrameTable {
 public:
  FrameTable();

  [[nodiscard]] std::optional<FrameId> find(std::string_view name) const;
  FrameId intern(std::string_view name);
  void add_removed();  // takes an id as if it had been interned and removed
  // The id is not used again, as stored samples may hold it. The frame is then nameless.
  void remove(FrameId id);

  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  Frame& operator[](FrameId id) { return *frames_[id]; }
  const Frame& operator[](FrameId id) const { return *frames_[id]; }

 private:
  std::vector<std::unique_ptr<Frame>> frames_;
  std::unordered_map<std::string_view, FrameId> ids_;  // keys live in the frames
};

}  // namespace tfloom::tf2
