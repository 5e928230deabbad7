// Inserts, lookups, waits, requests and listings at once on one buffer. Ends with 0 if every answer was sound; the
// sanitizer that it's built with watches the rest.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "checks.hpp"
#include "tf2/batch.hpp"
#include "tf2/buffer.hpp"

using namespace tfloom::tf2;

namespace {

constexpr Stamp step = 1'000'000;  // 1 kHz
constexpr Stamp start = 100'000'000'000;
constexpr int steps = 1000;
constexpr int links = 4;

std::atomic<bool> done{false};

std::string name_of(int index) { return "f" + std::to_string(index); }

// Link i is at x = i + 1 at all times: any sound answer along the chain has a known length.
void insert(Buffer& buffer, int parity) {
  for (int k = parity; k < steps; k += 2) {
    for (int i = 0; i < links; ++i) {
      const std::string parent = name_of(i), child = name_of(i + 1);
      const Entry entry{parent, child, start + k * step, {{i + 1.0, 0, 0}, {}}};
      buffer.set({&entry, 1}, "thread " + std::to_string(parity), i == 0);
    }
  }
}

void look_up(const Buffer& buffer) {
  const std::string target = name_of(0), source = name_of(links);
  int answers = 0;
  for (int n = 0; !done || answers == 0; ++n) {
    const auto found = buffer.lookup(Query::at(target, source, n % 3 == 0 ? latest : start + (n % steps) * step));
    if (!found) continue;
    ++answers;
    check(std::abs(found->value.translation.x - links * (links + 1) / 2.0) < 1e-9, "a lookup's length");
  }
}

void look_many_up(const Buffer& buffer) {
  const std::string target = name_of(0), source = name_of(links);
  std::vector<Stamp> stamps;
  for (int k = 0; k < steps; ++k) stamps.push_back(start + k * step + step / 3);
  std::vector<Transform> out(stamps.size());
  std::vector<std::uint8_t> known(stamps.size());
  std::vector<float> points(3 * stamps.size());
  for (int n = 0; !done; ++n) {
    if (n % 2 == 1) std::ranges::reverse(stamps);  // in another order they're sorted first
    lookup_many(buffer, target, source, stamps, out, known, false, 2);
    static_cast<void>(deskew(buffer, target, source, Transform{}, stamps, points.data(), points.data(), 2));
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (known[i]) check(std::abs(out[i].translation.x - links * (links + 1) / 2.0) < 1e-9, "one of many lengths");
    }
  }
}

void wait(const Buffer& buffer) {
  using namespace std::chrono_literals;
  const std::string target = name_of(0), source = name_of(links);
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  for (int k = 0; k < steps - 2; k += 50) {
    const Query query = Query::at(target, source, start + k * step);
    auto waited = Buffer::Waited::interrupted;
    while (waited == Buffer::Waited::interrupted) waited = buffer.wait(query, deadline, 50ms);
    check(waited == Buffer::Waited::yes, "a wait's end");
  }
}

void request(Buffer& buffer, std::atomic<int>& answered, int& asked) {
  const std::string target = name_of(0), source = name_of(links);
  for (int k = 0; k < steps - 2; k += 20) {
    const auto handle = buffer.add_request(Query::at(target, source, start + k * step),
                                           [&answered](Requests::Handle, Requests::Outcome) { ++answered; });
    if (handle == Requests::now || handle == Requests::never) continue;
    if (k % 40 == 0 && buffer.cancel_request(handle)) continue;
    ++asked;
  }
}

// What the newest links say is kept twice, and must change with every change.
void change(Buffer& buffer) {
  for (int k = 0; k < 500; ++k) {  // an id is not used again
    const Entry entry{"f0", "beside", start + k, {{1, 2, 3}, {}}};
    buffer.set({&entry, 1}, "beside", k % 3 == 0);
    const auto found = buffer.lookup(Query::at("f0", "beside", latest));
    check(found && found->value.translation == Vector3{1, 2, 3}, "a frame that was just set");
    check(buffer.remove_frame("beside"), "a frame to remove");
    check(!buffer.can(Query::at("f0", "beside", latest)), "a frame that was removed");
  }
}

void list(const Buffer& buffer) {
  while (!done) {
    check(buffer.frame_names().size() <= links + 2, "the number of frames");
    static_cast<void>(buffer.all_frames_as_yaml(0.0));
    static_cast<void>(buffer.latest_common_time(name_of(0), name_of(links)));
  }
}

}  // namespace

int main() {
  Buffer buffer(unlimited);
  buffer.set_log_callback([](Severity, const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); });
  std::atomic<int> answered{0};
  int asked = 0;
  std::vector<std::thread> readers;
  readers.emplace_back(look_up, std::cref(buffer));
  readers.emplace_back(look_up, std::cref(buffer));
  readers.emplace_back(look_many_up, std::cref(buffer));
  readers.emplace_back(list, std::cref(buffer));
  readers.emplace_back(change, std::ref(buffer));
  std::thread waiter(wait, std::cref(buffer));
  std::thread requester(request, std::ref(buffer), std::ref(answered), std::ref(asked));
  std::thread even(insert, std::ref(buffer), 0), odd(insert, std::ref(buffer), 1);
  even.join();
  odd.join();
  waiter.join();
  requester.join();
  done = true;
  for (std::thread& reader : readers) reader.join();
  check(answered == asked, "each request is answered once");
  return faults == 0 ? 0 : 1;
}
