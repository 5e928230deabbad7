#include "tf2/frames.hpp"

namespace tfloom::tf2 {

Stamp Frame::oldest_stamp() const { return kind == Kind::moving ? history->oldest_stamp() : 0; }

std::size_t Frame::sample_count() const {
  if (kind == Kind::moving) return history->size();
  return kind == Kind::fixed ? 1 : 0;
}

bool Frame::insert(const Sample& sample, bool is_static, Stamp max_age) {
  if (is_static) {
    kind = Kind::fixed;
    history.reset();
    fixed_parent = sample.parent;
    fixed_value = sample.value;
    return true;
  }
  if (kind != Kind::moving) {
    kind = Kind::moving;
    fixed_parent = no_parent;
    history = std::make_unique<TimeCache>(max_age);
  }
  return history->insert(sample);
}

void Frame::clear() {
  kind = Kind::root;
  fixed_parent = no_parent;
  history.reset();
  authority.clear();
}

void Frame::remove_parent(FrameId parent, Stamp max_age) {
  if (kind == Kind::fixed && fixed_parent == parent) return clear();
  if (kind != Kind::moving) return;
  bool has_any = false;
  history->for_each([&](Stamp, FrameId other, const Transform&) { has_any |= other == parent; });
  if (!has_any) return;
  auto kept = std::make_unique<TimeCache>(max_age);
  history->for_each([&](Stamp stamp, FrameId other, const Transform& value) {
    if (other != parent) kept->insert({stamp, other, value});
  });
  if (kept->empty()) return clear();
  history = std::move(kept);
}

FrameTable::FrameTable() { intern("NO_PARENT"); }

std::optional<FrameId> FrameTable::find(std::string_view name) const {
  const FrameId found = ids_.find(name, [this](FrameId id) -> std::string_view { return frames_[id]->name; });
  if (found == NameIndex::none) return std::nullopt;
  return found;
}

FrameId FrameTable::intern(std::string_view name) {
  if (const auto id = find(name)) return *id;
  const auto id = static_cast<FrameId>(frames_.size());
  Frame& frame = add();
  frame.name = name;
  ids_.add(frame.name, id);
  return id;
}

void FrameTable::add_removed() { add(); }

Frame& FrameTable::add() {
  // Reserve first, so that the three vectors keep equal lengths if an allocation fails.
  if (frames_.size() == frames_.capacity()) {
    const std::size_t room = 2 * frames_.size() + 16;
    newest_.reserve(room);
    newest_values_.reserve(room);
    frames_.reserve(room);
  }
  frames_.push_back(std::make_unique<Frame>());
  newest_.emplace_back();
  newest_values_.emplace_back();
  return *frames_.back();
}

void FrameTable::remove(FrameId id) {
  frames_[id]->clear();
  frames_[id]->name.clear();
  refresh_newest(id);
  ids_.clear();
  for (FrameId other = 0; other < frames_.size(); ++other) {
    if (!frames_[other]->name.empty()) ids_.add(frames_[other]->name, other);
  }
}

}  // namespace tfloom::tf2
