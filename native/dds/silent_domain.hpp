// A domain without a network, for tests of a libddsc.
#pragma once

#include <mutex>
#include <string>

#include "dds/entity.hpp"
#include "dds/library.hpp"
#include "dds/qos.hpp"

namespace tfloom::dds {

// A participant on a domain that no other has, because its number is above the largest one with a network, 232. One
// thread at a time has it.
class SilentDomain {
 public:
  static constexpr std::uint32_t id = 0x7466;
  static constexpr const char* configuration =
      "<CycloneDDS><Domain><General><Transport>none</Transport></General></Domain></CycloneDDS>";

  // Throw Error with the library's reason.
  SilentDomain(const Library& library, const std::string& user_data)
      : lock_(mutex_),
        domain_(library, library.create_domain(id, configuration), "its domain can't be opened"),
        participant_(library, library.create_participant(id, make_user_data(library, user_data).get(), nullptr),
                     "its participant can't be created") {}

  [[nodiscard]] Entity participant() const { return participant_.get(); }

 private:
  static inline std::mutex mutex_;
  const std::lock_guard<std::mutex> lock_;
  OwnedEntity domain_;
  OwnedEntity participant_;
};

}  // namespace tfloom::dds
