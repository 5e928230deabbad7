#include "tf2/frames.hpp"

namespace tfloom::tf2 {

FrameId Frame::newest_parent() const {
  return kind == Kind::moving ? history->newest_parent() : fixed_parent;
}

Stamp Frame::newest_stamp() const { return kind == Kind::moving ? history->newest_stamp() : 0; }

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

void Frame::forget() {
  kind = Kind::root;
  fixed_parent = no_parent;
  history.reset();
  authority.clear();
}

void Frame::forget_parent(FrameId parent, Stamp max_age) {
  if (kind == Kind::fixed && fixed_parent == parent) return forget();
  if (kind != Kind::moving) return;
  auto kept = std::make_unique<TimeCache>(max_age);
  history->for_each([&](Stamp stamp, FrameId other, const Transform& value) {
    if (other != parent) kept->insert({stamp, other, value});
  });
  if (kept->empty() && !history->empty()) return forget();
  history = std::move(kept);
}

FrameTable::FrameTable() { intern("NO_PARENT"); }

std::optional<FrameId> FrameTable::find(std::string_view name) const {
  const auto found = ids_.find(name);
  if (found == ids_.end()) return std::nullopt;
  return found->second;
}

FrameId FrameTable::intern(std::string_view name) {
  if (const auto known = find(name)) return *known;
  const auto id = static_cast<FrameId>(frames_.size());
  frames_.push_back(std::make_unique<Frame>());
  frames_.back()->name = name;
  ids_.emplace(frames_.back()->name, id);
  return id;
}

void FrameTable::add_removed() { frames_.push_back(std::make_unique<Frame>()); }

void FrameTable::remove(FrameId id) {
  ids_.erase(frames_[id]->name);
  frames_[id]->forget();
  frames_[id]->name.clear();
}

}  // namespace tfloom::tf2
