// Interned frame names, and the transforms of each frame to its parent.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tf2/name_index.hpp"
#include "tf2/time_cache.hpp"

namespace tfloom::tf2 {

struct Frame {
  enum class Kind : std::uint8_t { root, fixed, moving };

  std::string name;
  std::unique_ptr<TimeCache> history;  // of a moving frame
  Kind kind = Kind::root;
  FrameId fixed_parent = no_parent;
  std::string authority;  // of the last insert
  Transform fixed_value;

  // A static transform is valid at any time; a frame that was never a child has no data.
  [[nodiscard]] Bracket find(Stamp stamp) const {
    if (kind == Kind::moving) return history->find(stamp);
    if (kind == Kind::root) return {};
    return {Bracket::Found::yes, fixed_parent, &fixed_value, nullptr, 0.0};
  }
  [[nodiscard]] FrameId newest_parent() const { return kind == Kind::moving ? history->newest_parent() : fixed_parent; }
  [[nodiscard]] Stamp newest_stamp() const {  // 0: static, or no data
    return kind == Kind::moving ? history->newest_stamp() : 0;
  }
  [[nodiscard]] const Transform* newest_value() const {  // null: no data
    if (kind == Kind::moving) return history->newest_value();
    return kind == Kind::fixed ? &fixed_value : nullptr;
  }
  [[nodiscard]] Stamp oldest_stamp() const;
  [[nodiscard]] std::size_t sample_count() const;

  // Store a sample. If the frame was of the other kind, its former data is dropped. Return false if it is too old.
  bool insert(const Sample& sample, bool is_static, Stamp max_age);

  void remove_parent(FrameId parent, Stamp max_age);  // drop all samples whose parent is `parent`
  void clear();  // drop everything but the name, which makes it a root
};

// A copy of a frame's newest link to its parent. Queries of the latest time read only these copies, which are
// contiguous. From the histories, a lookup of depth 10 takes 21 % longer, and that of a humanoid 57 %:
// benchmarks/native, "newest links".
struct Newest {
  Stamp stamp = 0;  // 0: static, or no data
  FrameId parent = no_parent;
  bool moves = false;
};

// Ids are dense, in order of registration. Id 0 means "no parent" and has a reserved name.
class FrameTable {
 public:
  FrameTable();

  [[nodiscard]] std::optional<FrameId> find(std::string_view name) const;
  // Return the frame whose name has the same hash, without comparing names, or null.
  [[nodiscard]] const Frame* find_by_hash(std::string_view name) const {
    const FrameId id = ids_.find_by_hash(name);
    return id == NameIndex::none ? nullptr : frames_[id].get();
  }
  FrameId intern(std::string_view name);
  void add_removed();  // use up an id, as if a frame had been interned and removed
  // The frame has no name afterwards. The id is not used again, because stored samples may hold it.
  void remove(FrameId id);

  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  Frame& operator[](FrameId id) { return *frames_[id]; }
  const Frame& operator[](FrameId id) const { return *frames_[id]; }

  [[nodiscard]] const Newest& newest(FrameId id) const { return newest_[id]; }
  [[nodiscard]] const Transform& newest_value(FrameId id) const { return newest_values_[id]; }
  // Must be called after each change of a frame's data.
  void refresh_newest(FrameId id) {
    const Frame& frame = *frames_[id];
    newest_[id] = {frame.newest_stamp(), frame.newest_parent(), frame.kind == Frame::Kind::moving};
    if (const Transform* value = frame.newest_value()) newest_values_[id] = *value;
  }

 private:
  Frame& add();

  std::vector<std::unique_ptr<Frame>> frames_;
  std::vector<Newest> newest_;
  std::vector<Transform> newest_values_;
  NameIndex ids_;
};

}  // namespace tfloom::tf2
