#include "cdr/tf_observer.hpp"

#include <exception>

#include "cdr/cursor.hpp"
#include "cdr/tf_entries.hpp"
#include "cdr/tf_message.hpp"

namespace tfloom::cdr {
namespace {

// Stamps on the wire are below 2.2e18 ns in magnitude. With this bound, no difference of two times overflows.
constexpr tf2::Stamp max_time = 2'300'000'000'000'000'000;

tf2::Stamp bounded(tf2::Stamp time) { return std::clamp(time, -max_time, max_time); }

double seconds(tf2::Stamp ns) { return 1e-9 * static_cast<double>(ns); }

std::string hexadecimal(const Gid& gid) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * gid.size());
  for (const std::uint8_t octet : gid) {
    text += digits[octet >> 4];
    text += digits[octet & 15];
  }
  return text;
}

}  // namespace

void TfObserver::record(std::span<const tf2::Entry> entries, const SampleInfo& info, bool is_static, std::size_t size,
                        bool is_readable) {
  const tf2::Stamp received = bounded(info.received_stamp_ns);
  const std::lock_guard lock(mutex_);
  // A message of a publisher that finds no place is counted only as unrecorded, so that the sum of all counts is
  // complete.
  const auto id = find_publisher(info.publisher_gid, is_static);
  if (!id) {
    unrecorded_ += entries.size();
    return;
  }
  TfTraffic& traffic = publishers_[*id];
  if (traffic.messages == 0) {
    traffic.first_received = received;
  } else {
    traffic.period.add(seconds(received - traffic.last_received));
  }
  traffic.has_left = false;
  traffic.last_received = received;
  ++traffic.messages;
  traffic.bytes += size;
  if (!is_readable) ++traffic.unreadable;
  traffic.transforms += entries.size();
  traffic.max_transforms = std::max<std::uint64_t>(traffic.max_transforms, entries.size());
  if (info.source_stamp_ns != 0) traffic.transit.add(seconds(received - bounded(info.source_stamp_ns)));
  const tf2::Stamp now = bounded(simulated_time_.value_or(received));
  for (const tf2::Entry& entry : entries) add(*id, entry, received, now);
}

void TfObserver::add(Id publisher, const tf2::Entry& entry, tf2::Stamp received, tf2::Stamp now) {
  Edge* edge = find_edge(publisher, entry);
  if (edge == nullptr) {
    ++unrecorded_;
    return;
  }
  const bool is_static = publishers_[publisher].is_static;
  Child& child = children_[edge->key.child];
  // The edge compares the stamp with the child's newest one so far, so that comes after.
  edge->statistics.add(entry.stamp, entry.value, received, now, is_static, child.newest_stamp, cache_time_);
  if (child.parent != tf2::NameIndex::none && child.parent != edge->key.parent) ++child.reparented;
  child.parent = edge->key.parent;
  if (!is_static) child.newest_stamp = std::max(child.newest_stamp, entry.stamp);
}

std::optional<TfObserver::Id> TfObserver::find_publisher(const Gid& gid, bool is_static) {
  const PublisherKey key{gid, is_static};
  if (const auto entry = publisher_ids_.find(key); entry != publisher_ids_.end()) return entry->second;
  // Publishers that have left keep their statistics until their place is needed.
  if (publishers_.size() >= max_publishers || edges_.size() >= max_edges) drop_left();
  if (publishers_.size() >= max_publishers) return std::nullopt;
  const auto id = static_cast<Id>(publishers_.size());
  publishers_.emplace_back().gid = gid;
  publishers_.back().is_static = is_static;
  publisher_ids_.emplace(key, id);
  return id;
}

TfObserver::Id TfObserver::find_name(std::string_view name) const {
  return name_ids_.find(name, [this](Id id) -> std::string_view { return names_[id]; });
}

TfObserver::Id TfObserver::intern(std::string_view name) {
  const Id known_id = find_name(name);
  if (known_id != tf2::NameIndex::none) return known_id;
  const auto id = static_cast<Id>(names_.size());
  names_.emplace_back(name);
  children_.emplace_back();
  name_ids_.add(name, id);
  return id;
}

TfObserver::Edge* TfObserver::find_edge(Id publisher, const tf2::Entry& entry) {
  if (std::max(entry.child_frame_id.size(), entry.frame_id.size()) > max_name_size) return nullptr;
  // Look the names up before they are stored: an edge for which there is no room then leaves no names behind.
  EdgeKey key{publisher, find_name(entry.child_frame_id), find_name(entry.frame_id)};
  if (const auto place = edge_ids_.find(key); place != edge_ids_.end()) return &edges_[place->second];
  // Two names at most are new with each edge, so that they are bounded. Those of edges that were dropped remain.
  if (edges_.size() >= max_edges || names_.size() + 2 > 2 * max_edges) return nullptr;
  key.child = intern(entry.child_frame_id);
  key.parent = intern(entry.frame_id);
  edge_ids_.emplace(key, static_cast<Id>(edges_.size()));
  edges_.emplace_back().key = key;
  return &edges_.back();
}

void TfObserver::drop_left() {
  // Ids are indices, so those that remain get new ones: first the publishers, then the edges, whose keys name a
  // publisher. Names keep theirs.
  std::vector<Id> new_ids(publishers_.size(), tf2::NameIndex::none);
  std::vector<TfTraffic> publishers;
  publisher_ids_.clear();
  for (std::size_t i = 0; i < publishers_.size(); ++i) {
    if (publishers_[i].has_left) continue;
    new_ids[i] = static_cast<Id>(publishers.size());
    publisher_ids_.emplace(PublisherKey{publishers_[i].gid, publishers_[i].is_static}, new_ids[i]);
    publishers.push_back(publishers_[i]);
  }
  std::vector<Edge> edges;
  edge_ids_.clear();
  for (Edge& edge : edges_) {
    edge.key.publisher = new_ids[edge.key.publisher];
    if (edge.key.publisher == tf2::NameIndex::none) continue;
    edge_ids_.emplace(edge.key, static_cast<Id>(edges.size()));
    edges.push_back(edge);
  }
  publishers_ = std::move(publishers);
  edges_ = std::move(edges);
}

void TfObserver::mark_left(const Gid& publisher, bool is_static) {
  const std::lock_guard lock(mutex_);
  const auto entry = publisher_ids_.find({publisher, is_static});
  if (entry != publisher_ids_.end()) publishers_[entry->second].has_left = true;
}

void TfObserver::set_simulated_time(std::optional<tf2::Stamp> now) {
  const std::lock_guard lock(mutex_);
  simulated_time_ = now;
}

std::optional<tf2::Stamp> TfObserver::simulated_time() const {
  const std::lock_guard lock(mutex_);
  return simulated_time_;
}

void TfObserver::clear() {
  const std::lock_guard lock(mutex_);
  publishers_.clear();
  publisher_ids_.clear();
  names_.clear();
  children_.clear();
  name_ids_.clear();
  edges_.clear();
  edge_ids_.clear();
  unrecorded_ = 0;
}

TfSnapshot TfObserver::snapshot() const {
  TfSnapshot snapshot;
  const std::lock_guard lock(mutex_);
  snapshot.unrecorded = unrecorded_;
  snapshot.publishers = publishers_;
  snapshot.edges.reserve(edges_.size());
  for (const auto& [key, statistics] : edges_) {
    const TfTraffic& publisher = publishers_[key.publisher];
    snapshot.edges.push_back(
        {names_[key.child], names_[key.parent], publisher.gid, publisher.is_static, statistics});
  }
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const Child& child = children_[i];
    if (child.parent == tf2::NameIndex::none) continue;
    snapshot.children.push_back({names_[i], names_[child.parent], child.reparented, child.newest_stamp});
  }
  return snapshot;
}

void TfObserverSink::push(std::span<const std::byte> data, const SampleInfo& info) noexcept {
  try {
    if (!accepts(info.publisher_gid)) return;
    std::vector<tf2::Entry> entries;
    bool is_readable = true;
    try {
      read_tf_message(data, entries);
    } catch (const DecodeError&) {
      entries.clear();
      is_readable = false;
    }
    observer_->record(entries, info, is_static_, data.size(), is_readable);
    if (buffer_ != nullptr && !entries.empty()) buffer_->set(entries, hexadecimal(info.publisher_gid), is_static_);
    signal_push();
  } catch (const std::exception&) {  // out of memory: the message is dropped
  }
}

void TfObserverSink::accept_only(std::optional<std::vector<Gid>> publishers) {
  const std::lock_guard lock(mutex_);
  accepted_ = std::move(publishers);
}

bool TfObserverSink::accepts(const Gid& publisher) const {
  const std::lock_guard lock(mutex_);
  return !accepted_ || std::ranges::find(*accepted_, publisher) != accepted_->end();
}

void TfClockSink::push(std::span<const std::byte> data, const SampleInfo&) noexcept {
  try {
    Cursor in(data);
    observer_->set_simulated_time(read_stamp(in));
    signal_push();
  } catch (const std::exception&) {  // no Clock: the former time stays
  }
}

}  // namespace tfloom::cdr
