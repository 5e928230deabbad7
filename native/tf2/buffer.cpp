#include "tf2/buffer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/prefetch.hpp"
#include "tf2/chain.hpp"
#include "tf2/text.hpp"

namespace tfloom::tf2 {
namespace {

constexpr std::size_t min_prefetched = 4, max_prefetched = 64;  // transforms whose memory is prefetched at once

std::string_view without_slash(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return name;
}

bool has_nan(const Transform& t) {
  // The sum is NaN if one number is NaN, but also if there are infinities of both signs, so check each number then.
  const auto& [p, q] = t;
  if (!std::isnan(p.x + p.y + p.z + q.x + q.y + q.z + q.w)) return false;
  return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z) || std::isnan(q.x) || std::isnan(q.y) ||
         std::isnan(q.z) || std::isnan(q.w);
}

bool is_unit(const Quaternion& q) {
  constexpr double tolerance = 0.01;
  return std::abs(dot(q, q) - 1.0) < tolerance;
}

Transform target_from_source(ChainProduct& top_from_target, ChainProduct& top_from_source) {
  Transform result = inverse(top_from_target.value()) * top_from_source.value();
  result.rotation = canonical(result.rotation);
  return result;
}

// The visitors of `walk`. This one composes the links of both branches.
struct ChainComposer {
  ChainProduct top_from_source, top_from_target;

  void source(FrameId, const Bracket& link) { push(top_from_source, link); }
  void target(FrameId, const Bracket& link) { push(top_from_target, link); }
  void clear_source() { top_from_source.clear(); }

 private:
  static void push(ChainProduct& product, const Bracket& link) {
    product.push(link.newer ? link.value() : *link.older);
  }
};

// For checks, which need no values.
struct NoOpVisitor {
  void source(FrameId, const Bracket&) {}
  void target(FrameId, const Bracket&) {}
  void clear_source() {}
};

struct FrameNameCollector {
  const FrameTable& frames;
  Branches branches{};

  void source(FrameId id, const Bracket& link) { add(branches.source, id, link); }
  void target(FrameId id, const Bracket& link) { add(branches.target, id, link); }
  void clear_source() { branches.source.clear(); }

 private:
  void add(std::vector<std::string>& branch, FrameId id, const Bracket& link) {
    branch.push_back(frames[id].name);
    branches.top = frames[link.parent].name;  // the last link, at the top of the walk, sets the final value
  }
};

}  // namespace

std::size_t Buffer::set(std::span<const Entry> entries, std::string_view authority, bool is_static) {
  // What is rejected is reported after the lock is released, because the log may call a user's function. The entries'
  // names remain valid until then: they are the caller's.
  std::size_t stored = 0;
  std::vector<Rejection> rejections;
  {
    const std::unique_lock lock(frames_mutex_);
    ResolvedNames last;
    for (std::size_t begin = 0; begin < entries.size(); begin += max_prefetched) {
      const auto group = entries.subspan(begin, std::min(max_prefetched, entries.size() - begin));
      prefetch_frames(group);
      for (const Entry& entry : group) stored += insert(entry, authority, is_static, last, rejections) ? 1 : 0;
    }
  }
  for (const Rejection& rejection : rejections) report(rejection, authority);
  if (stored > 0) notify_waiters();
  return stored;
}

std::size_t Buffer::set_many(const Series& series, std::string_view authority) {
  constexpr std::size_t max_locked = 1024;
  std::size_t all_stored = 0;
  for (std::size_t begin = 0; begin < series.stamps.size(); begin += max_locked) {
    const std::size_t end = std::min(begin + max_locked, series.stamps.size());
    std::size_t stored = 0;
    std::vector<Rejection> rejections;
    {
      const std::unique_lock lock(frames_mutex_);
      ResolvedNames last;
      // `append` stores as much as it can in one step; the transform at which it stops is inserted with all checks, and
      // then it may go on. The first one is always inserted, because its frame isn't known yet.
      for (std::size_t i = begin; i < end;) {
        const std::size_t appended = append(series, i, end, authority, last);
        stored += appended;
        i += appended;
        if (i < end) stored += insert(series[i++], authority, false, last, rejections) ? 1 : 0;
      }
    }
    for (const Rejection& rejection : rejections) report(rejection, authority);
    if (stored > 0) notify_waiters();
    all_stored += stored;
  }
  return all_stored;
}

// Store the transforms from `begin` that `insert` would append to the frame's history without another effect, and return
// their number. `names` are those of a previous insert. Without it, set_many takes 3 times as long: benchmarks/native,
// "append".
std::size_t Buffer::append(const Series& series, std::size_t begin, std::size_t end, std::string_view authority,
                           const ResolvedNames& names) {
  if (names.child == no_parent || ignored_from_ != INT64_MAX) return 0;
  Frame& frame = frames_[names.child];
  if (frame.kind != Frame::Kind::moving || frame.history->empty()) return 0;
  // Copies, because another thread may be writing to the arrays.
  std::array<Stamp, TimeCache::block_size> stamps;
  std::array<Transform, TimeCache::block_size> values;
  std::size_t all = 0;
  for (std::size_t count = values.size(); count == values.size(); all += count) {
    Stamp newest = frame.history->newest_stamp();
    for (count = 0; count < std::min(values.size(), end - begin - all); ++count) {
      Entry entry = series[begin + all + count];
      entry.value.rotation = canonical(entry.value.rotation);
      if (entry.stamp <= newest || has_nan(entry.value) || !is_unit(entry.value.rotation)) break;
      newest = stamps[count] = entry.stamp;
      values[count] = entry.value;
    }
    frame.history->append(std::span(stamps).first(count), names.parent, std::span(values).first(count));
  }
  if (all == 0) return 0;
  frames_.refresh_newest(names.child);
  if (frame.authority != authority) frame.authority = authority;
  return all;
}

// The data of a robot's many frames is no longer in the processor's caches when new transforms arrive. For each frame
// it lies in ten places linked by pointers. Loading one level of pointers for all frames, then the next level, lets the
// cache misses of different frames overlap. (A history of one frame does not need it.) Without it, a transform takes 19
// % longer: benchmarks/native, "prefetch".
void Buffer::prefetch_frames(std::span<const Entry> entries) const {
  if (entries.size() < min_prefetched || entries.front().child_frame_id == entries.back().child_frame_id) return;
  std::array<const Frame*, max_prefetched> frames;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    frames[i] = frames_.find_by_hash(without_slash(entries[i].child_frame_id));
    if (frames[i] != nullptr) prefetch(frames[i], sizeof(Frame));
  }
  const auto for_each_history = [&](auto&& visit) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (frames[i] != nullptr && frames[i]->history) visit(*frames[i]->history);
    }
  };
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (frames[i] == nullptr) continue;
    prefetch(frames[i]->name.data());
    prefetch(frames[i]->authority.data());
  }
  for_each_history([](const TimeCache& history) { prefetch(&history, sizeof(TimeCache)); });
  for_each_history([](const TimeCache& history) { history.prefetch_blocks(); });
  for_each_history([](const TimeCache& history) { history.prefetch_ends(); });
}

bool Buffer::insert(Entry entry, std::string_view authority, bool is_static, ResolvedNames& last,
                    std::vector<Rejection>& rejections) {
  entry.frame_id = without_slash(entry.frame_id);
  entry.child_frame_id = without_slash(entry.child_frame_id);
  entry.value.rotation = canonical(entry.value.rotation);
  // A transform can have several faults, and each is reported, in this order.
  const std::size_t before = rejections.size();
  const auto reject_if = [&](bool is_so, Problem problem) {
    if (is_so) rejections.push_back({entry, problem});
  };
  reject_if(entry.child_frame_id == entry.frame_id, Problem::self);
  reject_if(entry.child_frame_id.empty(), Problem::child_unset);
  reject_if(entry.frame_id.empty(), Problem::parent_unset);
  reject_if(has_nan(entry.value), Problem::nan);
  reject_if(!is_unit(entry.value.rotation), Problem::denormalized);
  if (rejections.size() > before) return false;
  if (!is_static && is_ignored(entry.stamp)) return false;

  // Without the comparison with the previous names, set_many of shuffled stamps takes 13 % longer: benchmarks/native,
  // "names before".
  if (entry.child_frame_id != last.child_frame_id || entry.frame_id != last.frame_id) {
    const FrameId child = frames_.intern(entry.child_frame_id);  // before the parent: names are listed in this order
    last = {entry.frame_id, entry.child_frame_id, frames_.intern(entry.frame_id), child};
  }
  const FrameId parent = last.parent, child = last.child;
  Frame& frame = frames_[child];
  if (!frame.insert({entry.stamp, parent, entry.value}, is_static, cache_time_)) {
    rejections.push_back({entry, Problem::old});
    return false;
  }
  frames_.refresh_newest(child);
  if (frame.authority != authority) frame.authority = authority;
  return true;
}

void Buffer::report(const Rejection& rejection, std::string_view authority) {
  const std::string_view child = rejection.entry.child_frame_id;
  const auto& [p, q] = rejection.entry.value;
  const std::string position = join("(", fixed(p.x, 6), " ", fixed(p.y, 6), " ", fixed(p.z, 6), ")");
  const std::string rotation =
      join("(", fixed(q.x, 6), " ", fixed(q.y, 6), " ", fixed(q.z, 6), " ", fixed(q.w, 6), ")");
  const auto error = [&](std::string_view topic, const auto&... reason) {
    log_.report(Severity::error, topic, child, join(topic, ": Ignoring transform ", reason...));
  };
  switch (rejection.problem) {
    case Problem::self:
      return error("TF_SELF_TRANSFORM", "from authority \"", authority, "\" with frame_id and  child_frame_id \"",
                   child, "\" because they are the same");
    case Problem::child_unset:
      return error("TF_NO_CHILD_FRAME_ID", "from authority \"", authority, "\" because child_frame_id not set ");
    case Problem::parent_unset:
      return error("TF_NO_FRAME_ID", "with child_frame_id \"", child, "\"  from authority \"", authority,
                   "\" because frame_id not set");
    case Problem::nan:
      return error("TF_NAN_INPUT", "for child_frame_id \"", child, "\" from authority \"", authority,
                   "\" because of a nan value in the transform ", position, " ", rotation);
    case Problem::denormalized:
      return error("TF_DENORMALIZED_QUATERNION", "for child_frame_id \"", child, "\" from authority \"", authority,
                   "\" because of an invalid quaternion in the transform ", rotation);
    case Problem::old:
      return log_.report(Severity::warn, "TF_OLD_DATA", child,
                         join("TF_OLD_DATA ignoring data from the past for frame ", child, " at time ",
                              time_text(rejection.entry.stamp), " according to authority ", authority,
                              "\nPossible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"));
  }
}

bool Buffer::is_ignored(Stamp stamp) {
  if (stamp < ignored_from_) return false;  // also if nothing is ignored, without a look at the clock
  if (ignored_from_ != INT64_MAX && std::chrono::steady_clock::now() < ignored_until_) return true;
  ignored_from_ = INT64_MAX;
  return false;
}

void Buffer::ignore_from(Stamp stamp, std::chrono::nanoseconds duration) {
  const std::unique_lock lock(frames_mutex_);
  ignored_from_ = stamp;
  ignored_until_ = std::chrono::steady_clock::now() + duration;
}

void Buffer::clear() {
  const std::unique_lock lock(frames_mutex_);
  for (FrameId id = 0; id < frames_.size(); ++id) {
    if (!frames_[id].history) continue;
    frames_[id].history->clear();
    frames_.refresh_newest(id);
  }
}

std::optional<FrameId> Buffer::find_frame(std::string_view name) const {
  const auto id = frames_.find(name);
  return id == no_parent ? std::nullopt : id;
}

bool Buffer::resolve(const Query& query, Ids& ids) const {
  const auto target = find_frame(query.target), source = find_frame(query.source);
  const auto fixed = query.fixed ? find_frame(*query.fixed) : target;
  if (!target || !source || !fixed) return false;
  ids = {*target, *source, *fixed};
  // A frame inserted as "//a" is stored as "/a", but a query must not start with a slash.
  return !query.target.starts_with('/') && !query.source.starts_with('/') &&
         !(query.fixed && query.fixed->starts_with('/'));
}

Failure Buffer::lookup_at(FrameId target, FrameId source, Stamp stamp, StampedTransform& out) const {
  if (target == source) {
    out = {stamp == latest ? frames_[target].newest_stamp() : stamp, {}};
    return {};
  }
  // The newest common time comes from the frames' newest links alone. If every moving link has just that stamp, as when
  // one message has brought them all, the newest values are the answer, and no history is searched.
  ChainComposer composer;
  if (stamp == latest) {
    const NewestChain chain(frames_, target, source);
    if (chain.failure()) return chain.failure();
    stamp = chain.stamp();
    if (chain.is_uniform()) {
      for (const FrameId id : chain.source_links()) composer.top_from_source.push(frames_.newest_value(id));
      for (const FrameId id : chain.target_links()) composer.top_from_target.push(frames_.newest_value(id));
      out = {stamp, target_from_source(composer.top_from_target, composer.top_from_source)};
      return {};
    }
  }
  const Failure failure = walk(frames_, target, source, stamp, composer);
  if (!failure) out = {stamp, target_from_source(composer.top_from_target, composer.top_from_source)};
  return failure;
}

Failure Buffer::check_at(FrameId target, FrameId source, Stamp stamp) const {
  if (target == source) return {};
  if (stamp == latest) {
    const NewestChain chain(frames_, target, source);
    if (chain.failure() || chain.is_uniform()) return chain.failure();
    stamp = chain.stamp();
  }
  NoOpVisitor visitor;
  return walk(frames_, target, source, stamp, visitor);
}

Result<StampedTransform> Buffer::lookup(const Query& query) const {
  const ReadLock lock(frames_mutex_);
  if (!query.fixed && query.target == query.source) {
    const auto id = find_frame(query.target);
    const Stamp newest = id ? frames_[*id].newest_stamp() : 0;
    return StampedTransform{query.target_stamp == latest ? newest : query.target_stamp, {}};
  }
  Ids ids;
  if (!resolve(query, ids)) return name_error(query, Phrase::lookup);
  StampedTransform result;
  if (!query.fixed) {
    if (const Failure failure = lookup_at(ids.target, ids.source, query.target_stamp, result)) {
      return error_of(failure, ids.target, ids.source);
    }
    return result;
  }
  // Two lookups at two times, joined in the fixed frame. Both see the same data, because the lock is held for both.
  StampedTransform fixed_from_source;
  if (const Failure failure = lookup_at(ids.fixed, ids.source, query.source_stamp, fixed_from_source)) {
    return error_of(failure, ids.fixed, ids.source);
  }
  if (const Failure failure = lookup_at(ids.target, ids.fixed, query.target_stamp, result)) {
    return error_of(failure, ids.target, ids.fixed);
  }
  result.value = result.value * fixed_from_source.value;
  result.value.rotation = canonical(result.value.rotation);
  return result;
}

Error Buffer::find_error(const Query& query, const Ids& ids) const {
  if (!query.fixed) {
    const Failure failure = check_at(ids.target, ids.source, query.target_stamp);
    return failure ? error_of(failure, ids.target, ids.source) : Error{.code = Code::ok};
  }
  if (const Failure failure = check_at(ids.target, ids.fixed, query.target_stamp)) {
    return error_of(failure, ids.target, ids.fixed);
  }
  const Failure failure = check_at(ids.fixed, ids.source, query.source_stamp);
  return failure ? error_of(failure, ids.fixed, ids.source) : Error{.code = Code::ok};
}

Error Buffer::check(const Query& query) const {
  if (!query.fixed && query.target == query.source) return {.code = Code::ok};
  const ReadLock lock(frames_mutex_);
  Ids ids;
  return resolve(query, ids) ? find_error(query, ids) : name_error(query, Phrase::can);
}

bool Buffer::can(const Query& query) const {
  const ReadLock lock(frames_mutex_);
  return can_answer(query);
}

bool Buffer::can_answer(const Query& query) const {
  if (!query.fixed && query.target == query.source) return true;
  Ids ids;
  if (!resolve(query, ids)) return false;
  if (!query.fixed) return !check_at(ids.target, ids.source, query.target_stamp);
  return !check_at(ids.target, ids.fixed, query.target_stamp) &&
         !check_at(ids.fixed, ids.source, query.source_stamp);
}

Result<Stamp> Buffer::latest_common_time(std::string_view target, std::string_view source) const {
  const ReadLock lock(frames_mutex_);
  for (const std::string_view name : {target, source}) {
    if (Error error = name_error_of(name, "get_latest_common_time", Phrase::lookup); error.code != Code::ok) {
      return error;
    }
  }
  const FrameId target_id = *find_frame(target), source_id = *find_frame(source);
  const CommonTime common = tf2::latest_common_time(frames_, target_id, source_id);
  if (common.failure) return error_of(common.failure, target_id, source_id);
  return common.stamp;
}

Result<Branches> Buffer::branches(std::string_view target, std::string_view source, Stamp stamp) const {
  const ReadLock lock(frames_mutex_);
  const Query query = Query::at(target, source, stamp);
  Ids ids;
  if (!resolve(query, ids)) return name_error(query, Phrase::lookup);
  if (stamp == latest) {
    const CommonTime common = tf2::latest_common_time(frames_, ids.target, ids.source);
    if (common.failure) return error_of(common.failure, ids.target, ids.source);
    stamp = common.stamp;
  }
  FrameNameCollector names{.frames = frames_, .branches = {.target = {}, .source = {}, .top = std::string(source)}};
  if (const Failure failure = walk(frames_, ids.target, ids.source, stamp, names)) {
    return error_of(failure, ids.target, ids.source);
  }
  return std::move(names.branches);
}

}  // namespace tfloom::tf2
