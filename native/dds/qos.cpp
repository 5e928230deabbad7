#include "dds/qos.hpp"

namespace tfloom::dds {
namespace {

constexpr std::int32_t unlimited = -1;
constexpr int keep_last_kind = 0;
constexpr int keep_all_kind = 1;
constexpr int automatic_kind = 0;
constexpr int manual_by_topic_kind = 2;
constexpr std::int16_t xcdr1_representation = 0;

int history_kind(const Qos& qos) { return qos.history == History::keep_all ? keep_all_kind : keep_last_kind; }
std::int32_t depth(const Qos& qos) { return qos.history == History::keep_all ? unlimited : qos.depth; }

QosHandle make_endpoint_qos(const Library& l, const Qos& qos, const std::string& user_data,
                            std::int64_t longest_wait_ns = infinite_ns) {
  QosHandle handle = make_user_data(l, user_data);
  Qos_* q = handle.get();
  l.qset_reliability(q, qos.reliability == Reliability::reliable, longest_wait_ns);
  l.qset_durability(q, qos.durability == Durability::transient_local);
  l.qset_history(q, history_kind(qos), depth(qos));
  l.qset_deadline(q, qos.deadline_ns);
  l.qset_liveliness(q, qos.liveliness == Liveliness::manual_by_topic ? manual_by_topic_kind : automatic_kind,
                    qos.liveliness_lease_ns);
  l.qset_data_representation(q, 1, &xcdr1_representation);
  return handle;
}

}  // namespace

QosHandle make_user_data(const Library& l, const std::string& user_data) {
  QosHandle handle(l.create_qos(), {&l});
  l.qset_userdata(handle.get(), user_data.data(), user_data.size());
  return handle;
}

QosHandle make_writer_qos(const Library& l, const Qos& qos, const std::string& user_data, bool waits) {
  QosHandle handle = make_endpoint_qos(l, qos, user_data, waits ? infinite_ns : 0);
  l.qset_lifespan(handle.get(), qos.lifespan_ns);
  l.qset_writer_data_lifecycle(handle.get(), false);  // samples stay valid after their writer has left
  if (qos.durability == Durability::transient_local) {
    // These limits define how many samples are kept for late readers; by default it is one.
    l.qset_durability_service(handle.get(), 0, history_kind(qos), depth(qos), unlimited, unlimited, unlimited);
  }
  return handle;
}

QosHandle make_reader_qos(const Library& l, const Qos& qos, const std::string& user_data) {
  return make_endpoint_qos(l, qos, user_data);
}

Qos read_qos(const Library& l, const Qos_* q) {
  Qos qos;
  int kind = 0;
  std::int64_t max_blocking_ns = 0;
  if (l.qget_reliability(q, &kind, &max_blocking_ns)) {
    qos.reliability = kind == 0 ? Reliability::best_effort : Reliability::reliable;
  }
  if (l.qget_durability(q, &kind)) {
    constexpr Durability durabilities[] = {Durability::is_volatile, Durability::transient_local};
    qos.durability = kind == 0 || kind == 1 ? durabilities[kind] : Durability::unknown;
  }
  std::int32_t samples = 0;
  if (l.qget_history(q, &kind, &samples)) {
    qos.history = kind == keep_all_kind ? History::keep_all : History::keep_last;
    qos.depth = qos.history == History::keep_all ? 0 : samples;
  }
  if (l.qget_liveliness(q, &kind, &qos.liveliness_lease_ns)) {
    qos.liveliness = kind == automatic_kind         ? Liveliness::automatic
                     : kind == manual_by_topic_kind ? Liveliness::manual_by_topic
                                                    : Liveliness::unknown;
  }
  l.qget_deadline(q, &qos.deadline_ns);
  l.qget_lifespan(q, &qos.lifespan_ns);
  return qos;
}

std::string read_user_data(const Library& l, const Qos_* q) {
  void* data = nullptr;
  std::size_t size = 0;
  if (!l.qget_userdata(q, &data, &size) || data == nullptr) return {};
  const std::unique_ptr<void, void (*)(void*)> owner(data, l.free);
  return {static_cast<const char*>(data), size};
}

}  // namespace tfloom::dds
