// Conversion of quality of service between ROS's numbers and libddsc's object.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "dds/library.hpp"

namespace tfloom::dds {

enum class Reliability { reliable = 1, best_effort = 2 };
enum class Durability { transient_local = 1, is_volatile = 2, unknown = 3 };
enum class History { keep_last = 1, keep_all = 2 };
enum class Liveliness { automatic = 1, manual_by_topic = 3, unknown = 4 };

constexpr std::int64_t infinite_ns = INT64_MAX;

// Values numbered as in ROS and in tfloom.rmw.qos; durations in nanoseconds, where `infinite_ns` means no limit.
struct Qos {
  Reliability reliability = Reliability::reliable;
  Durability durability = Durability::is_volatile;
  History history = History::keep_last;
  std::int32_t depth = 1;
  std::int64_t deadline_ns = infinite_ns;
  std::int64_t lifespan_ns = infinite_ns;
  Liveliness liveliness = Liveliness::automatic;
  std::int64_t liveliness_lease_ns = infinite_ns;
};

struct QosDeleter {
  const Library* library;
  void operator()(Qos_* qos) const { library->delete_qos(qos); }
};
using QosHandle = std::unique_ptr<Qos_, QosDeleter>;

QosHandle make_user_data(const Library& library, const std::string& user_data);
// `waits` is whether a write waits for readers that lag behind.
QosHandle make_writer_qos(const Library& library, const Qos& qos, const std::string& user_data, bool waits = true);
QosHandle make_reader_qos(const Library& library, const Qos& qos, const std::string& user_data);

Qos read_qos(const Library& library, const Qos_* qos);
std::string read_user_data(const Library& library, const Qos_* qos);

}  // namespace tfloom::dds
