// Messages, snapshots, simulated times and departures at once on one observer. Ends with 0 if each transform was counted
// once; the sanitizer that it's built with watches the rest.
#include <atomic>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "cdr/tf_observer.hpp"

using namespace tfloom;

namespace {

constexpr int messages = 2000;
constexpr int frames = 20;

template <class T>
void append(std::vector<std::byte>& bytes, T value) {
  if constexpr (std::is_arithmetic_v<T>) {
    while ((bytes.size() - 4) % sizeof(T) != 0) bytes.push_back({});
    bytes.resize(bytes.size() + sizeof(T));
    std::memcpy(bytes.data() + bytes.size() - sizeof(T), &value, sizeof(T));
  } else {
    append(bytes, static_cast<std::uint32_t>(value.size() + 1));
    for (const char letter : value) bytes.push_back(static_cast<std::byte>(letter));
    bytes.push_back({});
  }
}

std::vector<std::byte> message(std::int32_t sec) {
  std::vector<std::byte> bytes{{}, std::byte{1}, {}, {}};  // CDR_LE
  append(bytes, static_cast<std::uint32_t>(frames));
  for (int i = 0; i < frames; ++i) {
    append(bytes, sec);
    append(bytes, std::uint32_t{0});
    append(bytes, std::string("base"));
    append(bytes, "frame" + std::to_string(i));
    for (int n = 0; n < 6; ++n) append(bytes, 0.5);
    append(bytes, 1.0);
  }
  return bytes;
}

void publish(cdr::TfObserverSink& sink, std::uint8_t number) {
  SampleInfo info;
  info.publisher_gid[0] = number;
  for (int i = 0; i < messages; ++i) {
    info.received_stamp_ns = i * std::int64_t{1'000'000'000};
    sink.push(message(i), info);
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
      if (now < before) std::fprintf(stderr, "fault: a count that shrinks\n");
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
  return count(observer->snapshot()) == 3ULL * messages * frames ? 0 : 1;
}
