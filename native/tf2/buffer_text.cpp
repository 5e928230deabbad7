// A buffer's tree as text, in tf2's layout.
#include <algorithm>

#include "tf2/buffer.hpp"
#include "tf2/text.hpp"

namespace tfloom::tf2 {
namespace {

// The values that the listings print for a frame with data.
struct Summary {
  std::string parent, authority;
  double rate_hz = 0.0, newest_s = 0.0, length_s = 0.0;
  Stamp newest = 0, oldest = 0;

  Summary(const FrameTable& frames, const Frame& frame)
      : parent(frames[frame.newest_parent()].name),
        authority(frame.authority.empty() ? "no recorded authority" : frame.authority),
        newest(frame.newest_stamp()),
        oldest(frame.oldest_stamp()) {
    constexpr double min_s = 1e-4;  // a single sample counts as 10 kHz
    newest_s = seconds(newest);
    // Unsigned, because the difference of extreme stamps overflows.
    length_s = static_cast<double>(static_cast<std::uint64_t>(newest) - static_cast<std::uint64_t>(oldest)) / 1e9;
    rate_hz = static_cast<double>(frame.sample_count()) / std::max(length_s, min_s);
  }
};

}  // namespace

std::vector<std::string> Buffer::frame_names() const {
  const ReadLock lock(frames_mutex_);
  std::vector<std::string> names;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    if (!frames_[id].name.empty()) names.push_back(frames_[id].name);  // a removed frame has none
  }
  return names;
}

bool Buffer::has_frame(std::string_view name) const {
  const ReadLock lock(frames_mutex_);
  return frames_.find(name).has_value();
}

std::string Buffer::all_frames_as_string() const {
  const ReadLock lock(frames_mutex_);
  return frames_as_string();
}

std::string Buffer::frames_as_string() const {
  std::string text;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    const Frame& frame = frames_[id];
    if (frame.kind == Frame::Kind::root) continue;
    text += join("Frame ", frame.name, " exists with parent ", frames_[frame.newest_parent()].name, ".\n");
  }
  return text;
}

std::string Buffer::all_frames_as_yaml(double now_s) const {
  const ReadLock lock(frames_mutex_);
  if (frames_.size() == 1) return "[]";
  std::string text;
  for (FrameId id = 1; id < frames_.size(); ++id) {
    const Frame& frame = frames_[id];
    if (frame.sample_count() == 0) continue;
    const Summary summary(frames_, frame);
    text += join(frame.name, ": \n");
    text += join("  parent: '", summary.parent, "'\n");
    text += join("  broadcaster: '", summary.authority, "'\n");
    text += join("  rate: ", fixed(summary.rate_hz, 3), "\n");
    text += join("  most_recent_transform: ", time_text(summary.newest), "\n");
    text += join("  oldest_transform: ", time_text(summary.oldest), "\n");
    if (now_s > 0.0) text += join("  transform_delay: ", fixed(now_s - summary.newest_s, 3), "\n");
    text += join("  buffer_length: ", fixed(summary.length_s, 3), "\n");
  }
  return text;
}

std::string Buffer::all_frames_as_dot(double now_s) const {
  const ReadLock lock(frames_mutex_);
  std::string text = "digraph G {\n";
  if (frames_.size() == 1) return text + "\"no tf data recieved\"}";
  for (FrameId id = 1; id < frames_.size(); ++id) {
    const Frame& frame = frames_[id];
    if (frame.sample_count() == 0) continue;
    const Summary summary(frames_, frame);
    text += join("\"", summary.parent, "\" -> \"", frame.name, "\"[label=\"");
    text += join("Broadcaster: ", summary.authority, "\\n");
    text += join("Average rate: ", fixed(summary.rate_hz, 3), " Hz\\n");
    text += join("Most recent transform: ", time_text(summary.newest), " ");
    if (now_s > 0.0) text += join("( ", fixed(now_s - summary.newest_s, 3), " sec old)");
    text += join("\\nBuffer length: ", fixed(summary.length_s, 3), " sec\\n\"];\n");
  }
  for (FrameId id = 1; id < frames_.size(); ++id) {
    const Frame& frame = frames_[id];
    if (frame.kind != Frame::Kind::moving || frame.sample_count() > 0) continue;  // emptied by clear
    text += "edge [style=invis];\n subgraph cluster_legend { style=bold; color=black; label =\"view_frames Result\";\n";
    if (now_s > 0.0) text += join("\"Recorded at time: ", fixed(now_s, 3), "\"[ shape=plaintext ] ;\n ");
    text += join("}->\"", frame.name, "\";\n");
  }
  return text + "}";
}

}  // namespace tfloom::tf2
