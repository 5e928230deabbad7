#include "robot/state_transforms.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cdr/cursor.hpp"
#include "cdr/writer.hpp"

namespace tfloom::robot {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
constexpr std::size_t numbers_size = 4 + 4 + 4 + 4 + 7 * 8 + 3 * 8;  // of one transform, with padding

// The storage of a Writer.
struct Bytes {
  std::vector<std::byte>& bytes;
  std::span<std::byte> resize(std::size_t size) const {
    bytes.resize(size);
    return bytes;
  }
};

}  // namespace

// A Transform is written as seven doubles in its own order.
static_assert(sizeof(tf2::Transform) == 7 * sizeof(double));

StateTransforms::StateTransforms(std::vector<MovingJoint> joints, std::vector<Mimicry> mimicries)
    : joints_(std::move(joints)),
      mimicries_(std::move(mimicries)),
      positions_(joints_.size()),
      is_known_(joints_.size()),
      is_received_(joints_.size()),
      published_ns_(joints_.size()) {
  index_.clear();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (variable_count(joints_[i].joint.kind) != 1) throw std::invalid_argument("a moving joint has one variable");
    index_.add(joints_[i].name, static_cast<std::uint32_t>(i));
    size_hint_ += numbers_size + joints_[i].frame_id.size() + joints_[i].child_frame_id.size();
  }
  for (const Mimicry& mimicry : mimicries_) {
    if (std::max(mimicry.joint, mimicry.source) >= joints_.size()) throw std::invalid_argument("no such joint");
  }
  size_hint_ += 16;
}

void StateTransforms::take(std::size_t joint, double position) {
  if (is_known_[joint]) return;
  if (!std::isfinite(position)) {
    if (!left_out_) left_out_ = joint;
    return;
  }
  positions_[joint] = position;
  is_known_[joint] = 1;
  ++known_count_;
}

bool StateTransforms::is_due(std::int64_t stamp_ns, std::int64_t now_ns,
                             std::optional<std::int64_t> interval_ns) const {
  if (!interval_ns) return true;
  std::int64_t last_ns = now_ns;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (is_received_[i]) last_ns = std::min(last_ns, published_ns_[i]);
  }
  return stamp_ns >= last_ns + *interval_ns;
}

void StateTransforms::read(std::span<const std::byte> data) {
  cdr::Cursor in(data);
  std::ranges::fill(is_known_, std::uint8_t{0});
  std::ranges::fill(is_received_, std::uint8_t{0});
  known_count_ = 0;
  left_out_.reset();
  sec_ = in.read<std::int32_t>();
  nanosec_ = in.read<std::uint32_t>();
  in.read_string();  // frame_id
  names_.resize(in.read_length(4));
  for (std::string_view& name : names_) name = in.read_string();
  if (in.read_length(sizeof(double)) != names_.size()) in.fail("the numbers of names and of positions differ");
  for (const std::string_view name : names_) {
    const auto position = in.read<double>();
    const std::uint32_t found =
        index_.find(name, [&](std::uint32_t id) -> const std::string& { return joints_[id].name; });
    if (found == tf2::NameIndex::none || is_received_[found]) continue;
    is_received_[found] = 1;
    take(found, position);
  }
  // Velocities and efforts are not read.
}

void StateTransforms::follow() {
  for (const Mimicry& mimicry : mimicries_) {
    if (is_known_[mimicry.source] && !is_received_[mimicry.joint]) {
      take(mimicry.joint, mimicry.multiplier * positions_[mimicry.source] + mimicry.offset);
    }
  }
}

std::vector<std::byte> StateTransforms::write() const {
  std::vector<std::byte> message;
  const Bytes bytes{message};
  cdr::Writer writer(bytes, size_hint_);
  writer.write(static_cast<std::uint32_t>(known_count_));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!is_known_[i]) continue;
    const MovingJoint& joint = joints_[i];
    writer.write(sec_);
    writer.write(nanosec_);
    writer.write_string(joint.frame_id);
    writer.write_string(joint.child_frame_id);
    const tf2::Transform pose = joint.joint.pose({&positions_[i], 1});
    writer.template write_all<double>(std::as_bytes(std::span(&pose, 1)));
  }
  message.resize(writer.size());
  return message;
}

std::vector<std::byte> StateTransforms::convert(std::span<const std::byte> data, std::int64_t now_ns,
                                                std::optional<std::int64_t> interval_ns) {
  const std::lock_guard lock(mutex_);
  read(data);
  const std::int64_t stamp_ns = sec_ * ns_per_s + nanosec_;
  if (!is_due(stamp_ns, now_ns, interval_ns)) return {};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (is_received_[i]) published_ns_[i] = stamp_ns;
  }
  follow();
  return known_count_ > 0 ? write() : std::vector<std::byte>();
}

void StateTransforms::forget_stamps() {
  const std::lock_guard lock(mutex_);
  std::ranges::fill(published_ns_, std::int64_t{0});
}

std::string StateTransforms::left_out() const {
  const std::lock_guard lock(mutex_);
  return left_out_ ? joints_[*left_out_].name : std::string();
}

}  // namespace tfloom::robot
