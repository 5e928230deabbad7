// The peers with which an endpoint is matched.
#pragma once

#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/sink.hpp"
#include "dds/library.hpp"

namespace tfloom::dds {

struct Peer {
  Gid gid{};
  std::string user_data;  // as received: untrusted bytes
};

class Peers {
 public:
  Peers(const Library& library, bool of_writer) : library_(library), of_writer_(of_writer) {}

  // Return the peers with which `entity` is matched now.
  [[nodiscard]] std::vector<Peer> matched(Entity entity);
  [[nodiscard]] std::size_t matched_count(Entity entity) const;

  // Return the gid of the peer with this handle; zeros if it left before the first call for it.
  [[nodiscard]] Gid gid(Entity entity, InstanceHandle handle);

 private:
  // Return the peer, or nullptr if it has left. The result is valid until the next call. Requires mutex_ to be held.
  const Peer* find(Entity entity, InstanceHandle handle);

  const Library& library_;
  bool of_writer_;
  std::mutex mutex_;  // held during calls of the library
  std::unordered_map<InstanceHandle, Peer> peers_by_handle_;  // guarded by mutex_
};

}  // namespace tfloom::dds
