// A reader of /tf that takes each sample on the library's thread and drops it, as the lower limit of CPU time.
// Prints the share of a core [%] and the messages a second.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "dds/endpoint.hpp"
#include "dds/qos.hpp"

using namespace tfloom::dds;

namespace {

std::atomic<long> taken{0};

void on_data_available(Entity reader, void* argument) {
  const Library& library = *static_cast<const Library*>(argument);
  Serdata_* serdata[64]{};
  SampleState states[64];
  const Result count = library.takecdr(reader, serdata, 64, states, 0);
  for (Result i = 0; i < count; ++i) library.serdata_unref(serdata[i]);
  taken += count;
}

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

double now_s(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace

// Arguments: path of libddsc, domain, configuration, seconds to warm up, seconds to measure.
int main(int, char** arguments) {
  const Library& library = Library::open(arguments[1]);
  Participant participant(library, static_cast<std::uint32_t>(std::atoi(arguments[2])), arguments[3], "enclave=/;", true);
  Qos qos;
  qos.depth = 100;
  const QosHandle handle = make_reader_qos(library, qos, "");
  Listener_* listener = library.create_listener(nullptr);
  library.lset_data_available_arg(listener, &on_data_available, const_cast<Library*>(&library), true);
  const OwnedEntity topic = create_topic(library, participant.entity(), {"rt/tf", "tf2_msgs::msg::dds_::TFMessage_"});
  library.check(library.create_reader(participant.subscriber(), topic.get(), handle.get(), listener), "cannot read");

  while (taken == 0) sleep_s(0.005);
  sleep_s(std::atof(arguments[4]));
  const double begin = now_s(CLOCK_MONOTONIC), cpu_begin = now_s(CLOCK_PROCESS_CPUTIME_ID);
  const long before = taken;
  sleep_s(std::atof(arguments[5]));
  const double elapsed = now_s(CLOCK_MONOTONIC) - begin, cpu = now_s(CLOCK_PROCESS_CPUTIME_ID) - cpu_begin;
  std::printf("%.4f %.1f\n", cpu / elapsed * 100, static_cast<double>(taken - before) / elapsed);
}
