#include "dds/participant.hpp"

#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "dds/loopback.hpp"
#include "dds/qos.hpp"

namespace tfloom::dds {
namespace {

struct OpenDomain {
  Entity entity = 0;  // 0: opened by other code in the process
  int users = 0;      // number of Domain objects
  bool is_bound = false;  // to the loopback interface
  std::string loopback_failure = "other code in this process has opened the domain before";
};

std::mutex domains_mutex;  // held during calls of the library

// The domains by library and id, because a forked process loads a separate library. Guarded by domains_mutex.
std::map<std::pair<const Library*, std::uint32_t>, OpenDomain> domains;

}  // namespace

Domain::Domain(const Library& library, std::uint32_t domain_id, const std::string& config, bool is_local)
    : library_(library), domain_id_(domain_id) {
  const std::lock_guard lock(domains_mutex);
  auto place = domains.find({&library, domain_id});
  if (place == domains.end()) {
    const Entity entity = library.create_domain(domain_id, config.c_str());
    if (entity != precondition_not_met) library.check(entity, "cannot open DDS domain " + std::to_string(domain_id));
    place = domains.emplace(std::pair{&library, domain_id}, OpenDomain{}).first;
    place->second.entity = entity > 0 ? entity : 0;
  }
  OpenDomain& domain = place->second;
  ++domain.users;
  if (!is_local) return;
  if (domain.entity > 0 && !domain.is_bound) {
    domain.loopback_failure = bind_to_loopback(domain_id);
    domain.is_bound = domain.loopback_failure.empty();
  }
  loopback_failure_ = domain.loopback_failure;
}

Domain::~Domain() {
  const std::lock_guard lock(domains_mutex);
  const auto domain = domains.find({&library_, domain_id_});
  if (--domain->second.users > 0) return;
  if (domain->second.entity > 0) library_.delete_entity(domain->second.entity);
  domains.erase(domain);
}

Participant::Participant(const Library& library, std::uint32_t domain_id, const std::string& config,
                         const std::string& user_data, bool is_local)
    : library_(library),
      process_(process_id()),
      domain_(std::make_unique<Domain>(library, domain_id, config, is_local)),
      loopback_failure_(domain_->loopback_failure()),
      entity_(library, library.create_participant(domain_id, make_user_data(library, user_data).get(), nullptr),
              "cannot join DDS domain " + std::to_string(domain_id)),
      publisher_(library, library.create_publisher(entity_.get(), nullptr, nullptr), "cannot make a publisher"),
      subscriber_(library, library.create_subscriber(entity_.get(), nullptr, nullptr), "cannot make a subscriber"),
      gid_(gid_of(library, entity_.get())),
      feeder_(std::make_unique<Feeder>()) {}

Participant::~Participant() { close(); }

bool Participant::is_forked() const { return process_ != process_id(); }

void Participant::close() {
  if (is_forked()) {
    // The feeder's thread does not exist in this process. Its condition variable is not destroyed, because the
    // destructor would wait for the thread that waited on it.
    static_cast<void>(feeder_.release());
    static_cast<void>(domain_.release());
    return;
  }
  if (!domain_) return;
  feeder_->stop();
  subscriber_.close();
  publisher_.close();
  entity_.close();
  domain_.reset();
}

Gid gid_of(const Library& library, Entity entity) {
  Guid guid{};
  library.check(library.get_guid(entity, &guid), "cannot get a GUID");
  Gid gid;
  std::memcpy(gid.data(), guid.bytes, gid.size());
  return gid;
}

}  // namespace tfloom::dds
