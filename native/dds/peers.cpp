#include "dds/peers.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "dds/qos.hpp"

namespace tfloom::dds {
namespace {

constexpr std::size_t max_known = 1024;  // includes peers that have left

}  // namespace

std::size_t Peers::matched_count(Entity entity) const {
  const Result count = (of_writer_ ? library_.get_matched_subscriptions : library_.get_matched_publications)(
      entity, nullptr, 0);
  return static_cast<std::size_t>(std::max(count, 0));
}

std::vector<Peer> Peers::matched(Entity entity) {
  std::vector<InstanceHandle> handles(matched_count(entity));
  const Result count = (of_writer_ ? library_.get_matched_subscriptions : library_.get_matched_publications)(
      entity, handles.data(), handles.size());
  handles.resize(std::min(handles.size(), static_cast<std::size_t>(std::max(count, 0))));
  const std::lock_guard lock(mutex_);
  std::vector<Peer> peers;
  for (const InstanceHandle handle : handles) {
    if (const Peer* peer = find(entity, handle)) peers.push_back(*peer);
  }
  return peers;
}

Gid Peers::gid(Entity entity, InstanceHandle handle) {
  const std::lock_guard lock(mutex_);
  const Peer* peer = find(entity, handle);
  return peer != nullptr ? peer->gid : Gid{};
}

const Peer* Peers::find(Entity entity, InstanceHandle handle) {
  // Remembered, because the library no longer describes a peer that has left, and its samples may be taken after that.
  if (const auto peer = peers_by_handle_.find(handle); peer != peers_by_handle_.end()) return &peer->second;
  const std::unique_ptr<DiscoveredEndpoint, void (*)(DiscoveredEndpoint*)> endpoint(
      (of_writer_ ? library_.get_matched_subscription_data : library_.get_matched_publication_data)(entity, handle),
      library_.builtintopic_free_endpoint);
  if (endpoint == nullptr) return nullptr;
  Peer peer;
  std::memcpy(peer.gid.data(), endpoint->key.bytes, peer.gid.size());
  peer.user_data = read_user_data(library_, endpoint->qos);
  if (peers_by_handle_.size() >= max_known) peers_by_handle_.clear();
  return &peers_by_handle_.emplace(handle, std::move(peer)).first->second;
}

}  // namespace tfloom::dds
