// Messages, snapshots, simulated times and departures at once on one observer. Ends with 0 if each transform was counted
// once; the sanitizer that it's built with watches the rest.
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "cdr/tf_observer.hpp"
#include "checks.hpp"
#include "tf_bytes.hpp"

using namespace tfloom;

namespace {

constexpr int messages = 2000;
constexpr int frames = 20;

void publish(cdr::TfObserverSink& sink, std::uint8_t number) {
  SampleInfo info;
  info.publisher_gid[0] = number;
  for (int i = 0; i < messages; ++i) {
    info.received_stamp_ns = i * std::int64_t{1'000'000'000};
    sink.push(tf_bytes(i, frames), info);
    if (i % 100 == 0) sink.forget(info.publisher_gid);
  }
}

std::uint64_t count(const cdr::TfSnapshot& snapshot) {
  std::uint64_t sum = snapshot.unrecorded;
  for (const cdr::TfEdge& edge : snapshot.edges) sum += edge.statistics.count;
  return sum;
}

}  // namespace

int main() {
  const auto observer = std::make_shared<cdr::TfObserver>();
  const auto buffer = std::make_shared<tf2::Buffer>();
  cdr::TfObserverSink moving(observer, false, buffer), fixed(observer, true, nullptr);
  std::atomic<bool> done{false};
  std::thread reader([&] {
    std::uint64_t before = 0;
    while (!done) {
      const std::uint64_t now = count(observer->snapshot());
      check(now >= before, "a count never shrinks");
      before = now;
    }
  });
  std::thread clock([&] {
    for (std::int64_t time = 0; !done; ++time) {
      observer->set_simulated_time(time);
      moving.accept_only(std::nullopt);
    }
  });
  std::vector<std::thread> publishers;
  for (std::uint8_t number = 0; number < 3; ++number) {
    publishers.emplace_back([&, number] { publish(number == 2 ? fixed : moving, number); });
  }
  for (std::thread& publisher : publishers) publisher.join();
  done = true;
  reader.join();
  clock.join();
  check(count(observer->snapshot()) == 3ULL * messages * frames, "each transform is counted once");
  return faults == 0 ? 0 : 1;
}
