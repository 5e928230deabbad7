// A buffer's tree as data, and the removal of frames.
#include "tf2/buffer.hpp"

namespace tfloom::tf2 {

std::vector<std::string> Branches::path() const {
  std::size_t up = source.size(), down = target.size();
  while (up > 0 && down > 0 && source[up - 1] == target[down - 1]) --up, --down;  // skip frames above the meeting point
  std::vector<std::string> path(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(up));
  path.push_back(up < source.size() ? source[up] : top);
  for (std::size_t i = down; i > 0; --i) path.push_back(target[i - 1]);
  return path;
}

std::vector<Edge> Buffer::edges() const {
  const ReadLock lock(frames_mutex_);
  std::vector<Edge> edges;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    const Frame& frame = frames_[id];
    if (frame.sample_count() == 0) continue;
    edges.push_back({.child_frame_id = frame.name,
                     .frame_id = frames_[frame.newest_parent()].name,
                     .authority = frame.authority,
                     .is_static = frame.kind == Frame::Kind::fixed,
                     .oldest = frame.oldest_stamp(),
                     .newest = frame.newest_stamp(),
                     .sample_count = frame.sample_count()});
  }
  return edges;
}

std::vector<Sample> Buffer::samples(std::string_view frame_id, std::string_view child_frame_id) const {
  const ReadLock lock(frames_mutex_);
  std::vector<Sample> samples;
  const auto parent = find_frame(frame_id), child = find_frame(child_frame_id);
  if (!parent || !child) return samples;
  const Frame& frame = frames_[*child];
  if (frame.kind == Frame::Kind::fixed && frame.fixed_parent == *parent) {
    samples.push_back({0, *parent, frame.fixed_value});
  }
  if (frame.kind != Frame::Kind::moving) return samples;
  samples.reserve(frame.history->size());
  frame.history->for_each([&](Stamp stamp, FrameId other, const Transform& value) {
    if (other == *parent) samples.push_back({stamp, other, value});
  });
  return samples;
}

bool Buffer::remove_frame(std::string_view name) {
  const std::unique_lock lock(frames_mutex_);
  const auto removed = find_frame(name);
  if (!removed) return false;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    frames_[id].remove_parent(*removed, cache_time_);
    frames_.refresh_newest(id);
  }
  frames_.remove(*removed);
  return true;
}

std::size_t Buffer::memory() const {
  const ReadLock lock(frames_mutex_);
  std::size_t bytes = 0;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    if (frames_[id].history) bytes += frames_[id].history->memory();
  }
  return bytes;
}

}  // namespace tfloom::tf2
