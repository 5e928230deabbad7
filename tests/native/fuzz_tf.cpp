// Fuzzes the path from the bytes of /tf to a buffer, the filter of stamps far ahead, the statistics of an observer, and
// a freeze of what was stored.
//
// An input: which of four publishers, which time, whether static or filtered; then the bytes of a TFMessage. For the
// arguments, see fuzzing.hpp.
#include <cstring>
#include <memory>
#include <optional>

#include "cdr/tf_message.hpp"
#include "cdr/tf_observer.hpp"
#include "fuzzing.hpp"

namespace {

using namespace tfloom;

constexpr std::int64_t times[] = {5'000'000'000, 0, 1, -1, INT64_MIN, INT64_MAX, 1'700'000'000'000'000'000, 20'000'000'000};
constexpr int inputs_per_buffer = 256;  // mutated names become frames, which a buffer never forgets
constexpr std::size_t head = 3;

struct Target {
  std::shared_ptr<tf2::Buffer> buffer = std::make_shared<tf2::Buffer>();
  cdr::TfSink filtered{buffer, "filtered", false, [](const auto&...) {}};
  cdr::TfSink moving{buffer, "moving", false, {}};
  cdr::TfSink fixed{buffer, "fixed", true, {}};
  std::shared_ptr<cdr::TfObserver> observer = std::make_shared<cdr::TfObserver>();
  cdr::TfObserverSink observed{observer, false, nullptr};
  cdr::TfObserverSink observed_fixed{observer, true, nullptr};
  cdr::TfClockSink clock{observer};
  int inputs = 0;
};

// What is mapped from a frozen buffer must freeze to the same bytes, and be as readable.
void check(const tf2::Buffer& buffer) {
  const auto frozen = buffer.freeze();
  const auto mapped = std::make_shared<tf2::Buffer>();
  mapped->map(frozen, nullptr);
  if (mapped->freeze() != frozen) fuzzing::fail("fuzz_tf", "a mapped buffer freezes to something else");
  for (const std::string& name : buffer.frame_names()) {
    static_cast<void>(mapped->lookup(tf2::Query::at("map", name, 0)));
    static_cast<void>(buffer.can(tf2::Query::at(name, "base", 5'000'000'000)));
  }
  static_cast<void>(buffer.all_frames_as_yaml(0.0));
}

// All that came is counted: by edge, or as beyond the limits.
void check(const cdr::TfObserver& observer) {
  const cdr::TfSnapshot snapshot = observer.snapshot();
  std::uint64_t sent = 0, recorded = snapshot.unrecorded;
  for (const cdr::TfTraffic& publisher : snapshot.publishers) sent += publisher.transforms;
  for (const cdr::TfEdge& edge : snapshot.edges) {
    const tf2::EdgeStatistics& statistics = edge.statistics;
    recorded += statistics.count;
    if (statistics.oldest_stamp > statistics.newest_stamp || statistics.non_finite > statistics.count ||
        statistics.receipt_period.count != statistics.count - 1) {
      fuzzing::fail("fuzz_tf", "the statistics of an edge contradict each other");
    }
  }
  if (sent != recorded) fuzzing::fail("fuzz_tf", "the observer has not counted each transform once");
}

bool run(std::span<const std::uint8_t> bytes) {
  static std::optional<Target> target;
  if (!target || target->inputs >= inputs_per_buffer) {
    if (target) {
      check(*target->buffer);
      check(*target->observer);
    }
    target.emplace();
  }
  ++target->inputs;
  if (bytes.size() < head) return false;
  // A copy that ends with its allocation, so that the sanitizer sees one byte too many.
  std::vector<std::byte> data(bytes.size() - head);
  if (!data.empty()) std::memcpy(data.data(), bytes.data() + head, data.size());
  SampleInfo info;
  info.publisher_gid[0] = bytes[0] % 4;
  info.received_stamp_ns = times[bytes[1] % std::size(times)];
  cdr::TfSink& sink = bytes[2] % 4 == 0 ? target->fixed : bytes[2] % 4 == 1 ? target->moving : target->filtered;
  if (bytes[2] == 0xff) sink.forget(info.publisher_gid);
  cdr::TfObserverSink& observed = bytes[2] % 4 == 0 ? target->observed_fixed : target->observed;
  if (bytes[2] == 0xff) observed.forget(info.publisher_gid);
  if (bytes[2] == 0xfe) target->clock.push(data, info);
  observed.push(data, info);
  const auto dropped = sink.dropped_count();
  sink.push(data, info);
  if (sink.publisher_count() > 4 || sink.held_count() > 4 * 128) fuzzing::fail("fuzz_tf", "the filter grows");
  return sink.dropped_count() == dropped;
}

}  // namespace

int main(int count, char** arguments) { return fuzzing::fuzz("fuzz_tf", run, {{0, 0, 2, 0, 1, 0, 0, 0, 0, 0, 0}}, count, arguments); }
