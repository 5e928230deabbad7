// Ownership of libddsc's objects: entities and listeners.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "dds/library.hpp"

namespace tfloom::dds {

struct ListenerDeleter {
  const Library* library;
  void operator()(Listener_* listener) const { library->delete_listener(listener); }
};
using ListenerHandle = std::unique_ptr<Listener_, ListenerDeleter>;

ListenerHandle make_listener(const Library& library);

// An entity, deleted with this object at the latest. A forked process has none of the library's threads, so there the
// entity is left alone.
class OwnedEntity {
 public:
  // Own `created`, the result of one of the library's create functions. If it is an error, throw Error: `failure`, then
  // the library's reason.
  OwnedEntity(const Library& library, Entity created, const std::string& failure);
  ~OwnedEntity();
  OwnedEntity(const OwnedEntity&) = delete;
  OwnedEntity& operator=(const OwnedEntity&) = delete;

  // The handle stays the same after `close`: the library answers with an error, so other threads may still use it.
  [[nodiscard]] Entity get() const { return entity_; }

  // Call the listener from now on, on the library's threads. It uses the members of the entity's owner, so all of them
  // must have been assigned. It is not called for what happened before. Throw Error with the library's reason.
  void listen(const ListenerHandle& listener);

  // Remove the listener. Return after a running call of it has ended.
  void stop_listening();

  // Remove the listener and delete the entity. Closing again does nothing.
  void close();

 private:
  [[nodiscard]] bool is_usable() const;

  // All but `entity_` are used by the owner's constructor and by one thread that closes it.
  const Library& library_;
  const Entity entity_;
  const std::int64_t process_;
  bool listens_ = false;
  bool closed_ = false;
};

// Return the number of this process: a fork has another one.
std::int64_t process_id();

}  // namespace tfloom::dds
