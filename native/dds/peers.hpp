// The peers that an endpoint is connected to.
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
  std::string user_data;  // as it came: hostile bytes
};

class Peers {
 public:
  Peers(const Library& library, bool of_writer) : library_(library), of_writer_(of_writer) {}

  // Those that `entity` is connected to now.
  [[nodiscard]] std::vector<Peer> matched(Entity entity);
  [[nodiscard]] std::size_t matched_count(Entity entity) const;

  // The peer with this handle; zeros if it left before the first look-up.
  [[nodiscard]] Gid gid(Entity entity, InstanceHandle handle);

 private:
  const Peer* find(Entity entity, InstanceHandle handle);  // nullptr: it has left; lives until the next call

  const Library& library_;
  bool of_writer_;
  std::mutex mutex_;  // held while the library is called
  std::unordered_map<InstanceHandle, Peer> known_;  // guarded by mutex_
};

}  // namespace tfloom::dds
