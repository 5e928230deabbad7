// Measure threads that look up without a pause beside threads that insert 1000 times a second each, on one buffer. Print
// the p99 of lookups and of inserts [us], the inserts a second, and the number of wrong answers.
//
//     beside_writers READERS WRITERS SECONDS
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tf2/buffer.hpp"

namespace {

using namespace tfloom::tf2;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr Stamp start = 100'000'000'000, step = 1'000'000;
constexpr std::size_t links = 50;

using Times = std::vector<double>;

// Repeat `work` until `done`, at most once a `period`. A late call does not shorten the following pauses.
template <class Work>
Times time_until(const std::atomic<bool>& done, std::chrono::microseconds period, Work&& work) {
  Times times;
  while (!done) {
    const auto begin = Clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    if (period.count() > 0) std::this_thread::sleep_until(begin + period);
  }
  return times;
}

double p99(const std::vector<Times>& all) {
  Times times;
  for (const Times& some : all) times.insert(times.end(), some.begin(), some.end());
  std::ranges::sort(times);
  return times.empty() ? 0.0 : times[times.size() * 99 / 100];
}

}  // namespace

int main(int, char** arguments) {
  const auto readers = std::strtoul(arguments[1], nullptr, 10), writers = std::strtoul(arguments[2], nullptr, 10);
  const double seconds = std::strtod(arguments[3], nullptr);
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= links; ++i) names.push_back("f" + std::to_string(i));
  Buffer buffer;
  std::atomic<Stamp> newest = start;
  const auto insert = [&] {
    const Stamp stamp = newest += step;
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < links; ++i) entries.push_back({names[i], names[i + 1], stamp, {{1, 0, 0}, {}}});
    buffer.set(entries, "writer", false);
  };
  std::atomic<int> wrong = 0;
  const auto look_up = [&] {
    const auto found = buffer.lookup(Query::at(names.front(), names.back(), latest));
    if (!found || found->value.translation.x != static_cast<double>(links)) ++wrong;
  };
  insert();
  std::atomic<bool> done = false;
  std::vector<Times> lookups(readers), inserts(writers);
  std::vector<std::thread> threads;
  for (Times& times : lookups) threads.emplace_back([&] { times = time_until(done, 0us, look_up); });
  for (Times& times : inserts) threads.emplace_back([&] { times = time_until(done, 1000us, insert); });
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  done = true;
  for (std::thread& thread : threads) thread.join();
  std::size_t inserted = 0;
  for (const Times& times : inserts) inserted += times.size();
  std::printf("%f %f %f %d\n", p99(lookups), p99(inserts), static_cast<double>(inserted) / seconds, wrong.load());
}
