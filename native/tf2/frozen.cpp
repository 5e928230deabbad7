#include "tf2/frozen.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "core/utf8.hpp"
#include "tf2/buffer.hpp"
#include "tf2/text.hpp"

namespace tfloom::tf2 {
namespace {

constexpr std::size_t alignment = 8;

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    put_bytes(&value, sizeof value);
  }
  void put_bytes(const void* from, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(from);
    out_.insert(out_.end(), bytes, bytes + size);
  }
  void pad() { out_.resize((out_.size() + alignment - 1) / alignment * alignment); }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(out_); }

  explicit Writer(std::size_t size) { out_.reserve(size); }

 private:
  std::vector<std::byte> out_;
};

constexpr std::uint64_t padded(std::uint64_t size) { return (size + alignment - 1) / alignment * alignment; }

constexpr std::uint64_t samples_size(std::uint64_t count) {
  return padded(count * (sizeof(Stamp) + sizeof(Transform) + sizeof(FrameId)));
}

FrozenFrame::Kind kind_of(const Frame& frame) {
  if (frame.name.empty()) return FrozenFrame::Kind::removed;
  switch (frame.kind) {
    case Frame::Kind::root: return FrozenFrame::Kind::root;
    case Frame::Kind::fixed: return FrozenFrame::Kind::fixed;
    case Frame::Kind::moving: break;
  }
  return FrozenFrame::Kind::moving;
}

FrozenFrame record_of(const Frame& frame) {
  FrozenFrame record{.kind = kind_of(frame)};
  record.name_size = static_cast<std::uint32_t>(frame.name.size());
  record.authority_size = static_cast<std::uint32_t>(frame.authority.size());
  if (record.kind == FrozenFrame::Kind::fixed) {
    record.fixed_parent = frame.fixed_parent;
    record.fixed_value = frame.fixed_value;
  }
  if (record.kind == FrozenFrame::Kind::moving) record.sample_count = frame.history->size();
  return record;
}

// Reads the parts in order; each size is checked against the bytes that are left.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : data_(bytes) {}

  template <class T>
  std::span<const T> view(std::uint64_t count, std::string_view what) {
    const std::size_t left = data_.size() - at_;
    if (count > left / sizeof(T)) {
      fail(join(what, " takes ", std::to_string(count), " times ", std::to_string(sizeof(T)), " bytes, ",
                std::to_string(left), " are left"));
    }
    const std::span<const T> items(reinterpret_cast<const T*>(data_.data() + at_), static_cast<std::size_t>(count));
    at_ += items.size_bytes();
    return items;
  }
  void skip_padding() { at_ = std::min<std::size_t>(static_cast<std::size_t>(padded(at_)), data_.size()); }
  [[nodiscard]] std::size_t left() const { return data_.size() - at_; }

  [[noreturn]] void fail(const std::string& reason) const {
    throw FrozenError(join("byte ", std::to_string(at_), ": ", reason));
  }

 private:
  std::span<const std::byte> data_;
  std::size_t at_ = 0;
};

const FrozenHeader& read_header(Reader& in, std::span<const std::byte> bytes) {
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignment != 0) in.fail("the memory isn't aligned to 8 bytes");
  const auto& header = in.view<FrozenHeader>(1, "the header")[0];
  if (header.magic != FrozenHeader::expected_magic) in.fail("this is no frozen buffer");
  if (header.order != FrozenHeader::expected_order) {
    in.fail("it was frozen on a machine with another byte order; freeze it again on one like this");
  }
  if (header.version != FrozenHeader::expected_version) {
    in.fail(join("its format is version ", std::to_string(header.version), ", and this program reads version ",
                 std::to_string(FrozenHeader::expected_version)));
  }
  if (header.size != bytes.size()) {
    in.fail(join("it was ", std::to_string(header.size), " bytes long when it was written, and has ",
                 std::to_string(bytes.size()), " now"));
  }
  if (header.cache_time < 0) in.fail("its cache time is negative");
  if (header.frame_count >= UINT32_MAX) in.fail("it has more frames than there are ids");
  return header;
}

// Read the texts, and intern the names so that each frame gets its former id.
void read_names(Reader& in, std::span<const FrozenFrame> records, std::uint64_t text_size, FrameTable& frames) {
  Reader texts(in.view<std::byte>(text_size, "the text"));
  in.skip_padding();
  const auto read = [&](std::uint32_t size, std::string_view what) {
    const auto bytes = texts.view<char>(size, what);
    const std::string_view text(bytes.data(), bytes.size());
    if (!is_utf8(text)) texts.fail(join(what, " is not UTF-8"));
    return text;
  };
  for (const FrozenFrame& record : records) {
    const std::string_view name = read(record.name_size, "a frame's name");
    const std::string_view authority = read(record.authority_size, "an authority's name");
    const bool is_removed = record.kind == FrozenFrame::Kind::removed;
    if (name.empty() != is_removed) texts.fail("only a frame that was removed has no name");
    if (is_removed) {
      frames.add_removed();
      continue;
    }
    const FrameId id = static_cast<FrameId>(frames.size());
    if (frames.intern(name) != id) texts.fail(join("the frame '", name, "' is there twice"));
    frames[id].authority = authority;
  }
  if (texts.left() > 0) texts.fail("there is more text than the frames have");
}

void read_samples(Reader& in, std::uint64_t count, Stamp max_age, std::size_t frame_count, Frame& frame) {
  frame.history = std::make_unique<TimeCache>(max_age);
  const auto stamps = in.view<Stamp>(count, "the stamps of a frame");
  const auto values = in.view<Transform>(count, "the values of a frame");
  const auto parents = in.view<FrameId>(count, "the parents of a frame");
  if (!std::ranges::is_sorted(stamps)) in.fail(join("the stamps of the frame '", frame.name, "' don't ascend"));
  const auto is_unknown = [&](FrameId id) { return id >= frame_count; };  // a parent may be named NO_PARENT: id 0
  if (std::ranges::any_of(parents, is_unknown)) in.fail(join("a parent of the frame '", frame.name, "' is unknown"));
  frame.history->view(stamps, parents, values);
  in.skip_padding();
}

void read_contents(Reader& in, const FrozenFrame& record, Stamp max_age, std::size_t frame_count, Frame& frame) {
  using Kind = FrozenFrame::Kind;
  if (record.kind > Kind::removed) in.fail(join("the frame '", frame.name, "' is of an unknown kind"));
  if (record.kind != Kind::moving && record.sample_count > 0) {
    in.fail(join("the frame '", frame.name, "' has samples, though it doesn't move"));
  }
  if (record.kind == Kind::fixed) {
    if (record.fixed_parent >= frame_count) {
      in.fail(join("the parent of the frame '", frame.name, "' is unknown"));
    }
    frame.kind = Frame::Kind::fixed;
    frame.fixed_parent = record.fixed_parent;
    frame.fixed_value = record.fixed_value;
  }
  if (record.kind == Kind::moving) {
    frame.kind = Frame::Kind::moving;
    read_samples(in, record.sample_count, max_age, frame_count, frame);
  }
}

}  // namespace

std::vector<std::byte> freeze(const FrameTable& frames, Stamp cache_time) {
  FrozenHeader header{.cache_time = cache_time, .frame_count = frames.size() - 1};
  std::uint64_t sample_bytes = 0;
  for (FrameId id = 1; id < frames.size(); ++id) {
    const FrozenFrame record = record_of(frames[id]);
    header.text_size += std::uint64_t{record.name_size} + record.authority_size;
    sample_bytes += samples_size(record.sample_count);
  }
  header.size = sizeof header + header.frame_count * sizeof(FrozenFrame) + padded(header.text_size) + sample_bytes;
  Writer out(static_cast<std::size_t>(header.size));
  out.put(header);
  for (FrameId id = 1; id < frames.size(); ++id) out.put(record_of(frames[id]));
  for (FrameId id = 1; id < frames.size(); ++id) {
    out.put_bytes(frames[id].name.data(), frames[id].name.size());
    out.put_bytes(frames[id].authority.data(), frames[id].authority.size());
  }
  out.pad();
  for (FrameId id = 1; id < frames.size(); ++id) {
    if (!frames[id].history) continue;
    const TimeCache& history = *frames[id].history;
    history.for_each([&](Stamp stamp, FrameId, const Transform&) { out.put(stamp); });
    history.for_each([&](Stamp, FrameId, const Transform& value) { out.put(value); });
    history.for_each([&](Stamp, FrameId parent, const Transform&) { out.put(parent); });
    out.pad();
  }
  return out.take();
}

FrozenContents read_frozen(std::span<const std::byte> frozen) {
  Reader in(frozen);
  const FrozenHeader& header = read_header(in, frozen);
  const auto records = in.view<FrozenFrame>(header.frame_count, "the list of frames");
  FrozenContents contents{.cache_time = header.cache_time};
  read_names(in, records, header.text_size, contents.frames);
  for (std::size_t i = 0; i < records.size(); ++i) {
    Frame& frame = contents.frames[static_cast<FrameId>(i + 1)];
    read_contents(in, records[i], header.cache_time, contents.frames.size(), frame);
    contents.frames.refresh_newest(static_cast<FrameId>(i + 1));
  }
  if (in.left() > 0) in.fail(join(std::to_string(in.left()), " bytes are left over"));
  return contents;
}

std::vector<std::byte> Buffer::freeze() const {
  const ReadLock lock(frames_mutex_);
  return tf2::freeze(frames_, cache_time_);
}

void Buffer::map(std::span<const std::byte> frozen, std::shared_ptr<const void> owner) {
  FrozenContents contents = read_frozen(frozen);
  {
    const std::unique_lock lock(frames_mutex_);
    std::swap(frames_, contents.frames);
    std::swap(mapped_, owner);
    cache_time_ = contents.cache_time;
  }
  contents = {};  // without the lock; the former frames are destroyed before `owner`, whose memory they may view
  notify_waiters();
}

}  // namespace tfloom::tf2
