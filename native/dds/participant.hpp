// This process on one DDS domain.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/sink.hpp"
#include "dds/entity.hpp"
#include "dds/feeder.hpp"
#include "dds/library.hpp"

namespace tfloom::dds {

// A domain opened with a configuration, until the last participant has left it. If other code in this process has
// opened the domain before, that one is used.
class Domain {
 public:
  // If `is_local`, the domain's sockets are bound to the loopback interface where the system allows it.
  Domain(const Library& library, std::uint32_t domain_id, const std::string& config, bool is_local);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  // The reason why the sockets are not bound as requested; empty if they are, or if this was not requested.
  [[nodiscard]] const std::string& loopback_failure() const { return loopback_failure_; }

 private:
  const Library& library_;
  const std::uint32_t domain_id_;
  std::string loopback_failure_;  // constant after construction
};

class Participant {
 public:
  // Join a domain. `config` is Cyclone's XML; `user_data` is published to all participants (`enclave=/;`). If `is_local`,
  // the domain's sockets are bound to the loopback interface where the system allows it.
  // Throw Error with the library's reason.
  Participant(const Library& library, std::uint32_t domain_id, const std::string& config,
              const std::string& user_data, bool is_local);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  // Leave the domain, after all endpoints are closed: wait for the feeder's work, unless this is the feeder's own
  // thread. Closing again does nothing.
  void close();

  [[nodiscard]] const Library& library() const { return library_; }
  [[nodiscard]] Feeder& feeder() { return *feeder_; }
  [[nodiscard]] const Gid& gid() const { return gid_; }
  [[nodiscard]] const std::string& loopback_failure() const { return loopback_failure_; }
  [[nodiscard]] Entity entity() const { return entity_.get(); }
  [[nodiscard]] Entity publisher() const { return publisher_.get(); }
  [[nodiscard]] Entity subscriber() const { return subscriber_.get(); }

  // Return whether this is a fork of the process that joined. libddsc's threads do not exist in a fork, so its
  // functions must not be called.
  [[nodiscard]] bool is_forked() const;

 private:
  // All are constant after construction. One thread calls `close`, after all endpoints are closed.
  const Library& library_;
  std::int64_t process_;
  std::unique_ptr<Domain> domain_;
  const std::string loopback_failure_;  // of the domain, which is left before this object ends
  OwnedEntity entity_;
  OwnedEntity publisher_;
  OwnedEntity subscriber_;
  Gid gid_;
  std::unique_ptr<Feeder> feeder_;
};

Gid gid_of(const Library& library, Entity entity);

}  // namespace tfloom::dds
