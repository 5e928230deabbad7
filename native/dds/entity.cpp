#include "dds/entity.hpp"

#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

namespace tfloom::dds {

std::int64_t process_id() {
#ifdef _WIN32
  return _getpid();
#else
  return getpid();
#endif
}

ListenerHandle make_listener(const Library& library) { return {library.create_listener(nullptr), {&library}}; }

OwnedEntity::OwnedEntity(const Library& library, Entity created, const std::string& failure)
    : library_(library), entity_(library.check(created, failure)), process_(process_id()) {}

OwnedEntity::~OwnedEntity() { close(); }

bool OwnedEntity::is_usable() const { return !closed_ && process_ == process_id(); }

void OwnedEntity::listen(const ListenerHandle& listener) {
  listens_ = true;
  library_.check(library_.set_listener(entity_, listener.get()), "cannot listen");
}

void OwnedEntity::stop_listening() {
  if (listens_ && is_usable()) library_.set_listener(entity_, nullptr);
  listens_ = false;
}

void OwnedEntity::close() {
  stop_listening();
  if (is_usable()) library_.delete_entity(entity_);
  closed_ = true;
}

}  // namespace tfloom::dds
