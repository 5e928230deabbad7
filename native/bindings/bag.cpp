// The queue of messages that a recording writes.

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/unique_ptr.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "bag/chunk_queue.hpp"
#include "bag/mcap_records.hpp"
#include "bindings/bindings.hpp"
#include "bindings/gil.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using bag::Chunk;
using bag::ChunkQueue;
using bag::ChunkSink;

// Shares the queue with sinks, which use it on other threads without Python.
struct QueueHandle {
  std::shared_ptr<ChunkQueue> queue;
};

// Return a channel's entries as MCAP's message index holds them: pairs of log time and offset.
nb::bytes index_of(const Chunk& chunk, std::size_t channel, std::uint64_t shift) {
  const auto& entries = chunk.index[channel];
  std::vector<std::uint8_t> bytes;
  bytes.reserve(entries.size() * 16);
  const auto put = [&bytes](std::uint64_t value) {
    for (std::size_t i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  for (const auto& entry : entries) {
    put(static_cast<std::uint64_t>(entry.log_time));
    put(entry.offset + shift);
  }
  return nb::bytes(bytes.data(), bytes.size());
}

nb::list counts(const Chunk& chunk) {
  nb::list result;
  for (std::size_t channel = 0; channel < chunk.index.size(); ++channel) {
    if (!chunk.index[channel].empty()) result.append(nb::make_tuple(channel, chunk.index[channel].size()));
  }
  return result;
}

nb::list messages(const Chunk& chunk) {
  nb::list result;
  bag::RecordReader reader(chunk.records, 0);
  while (reader.advance()) {
    const bag::MessageRecord message = reader.message();
    result.append(nb::make_tuple(message.channel, static_cast<std::int64_t>(message.log_time),
                                 static_cast<std::int64_t>(message.publish_time),
                                 nb::bytes(chunk.records.data() + message.offset, message.size)));
  }
  return result;
}

std::unique_ptr<Chunk> take(QueueHandle& self, std::int64_t timeout_ns) {
  const ReleasedGil release;
  return self.queue->take(std::chrono::nanoseconds(timeout_ns));
}

void wait(QueueHandle& self, std::int64_t timeout_ns) {
  const ReleasedGil release;
  self.queue->wait(std::chrono::nanoseconds(timeout_ns));
}

bool push(QueueHandle& self, std::uint16_t channel, const nb::bytes& data, std::int64_t log_time_ns,
          std::int64_t publish_time_ns) {
  const std::span bytes(static_cast<const std::byte*>(data.data()), data.size());
  return self.queue->push(channel, bytes, log_time_ns, publish_time_ns);
}

// Wrap a method of the queue without an argument, or with one.
template <auto method>
auto call(QueueHandle& self) {
  return ((*self.queue).*method)();
}
template <auto method, typename Argument>
void call_with(QueueHandle& self, Argument argument) {
  ((*self.queue).*method)(argument);
}

void bind_chunk(nb::module_& m) {
  nb::class_<Chunk>(m, "Chunk", "Messages as MCAP message records, in the order in which they were pushed.")
      .def_ro("start_ns", &Chunk::start, "Smallest log time [ns since epoch].")
      .def_ro("end_ns", &Chunk::end, "Greatest log time [ns since epoch].")
      .def_ro("message_count", &Chunk::message_count, "Number of messages; at least one.")
      .def_ro("starts_file", &Chunk::starts_file, "Whether it is the first one of a new file.")
      .def_prop_ro(
          "records",
          [](const Chunk& self) { return nb::bytes(self.records.data(), self.records.size()); }, "The records.")
      .def("counts", &counts, nb::sig("def counts(self) -> list[tuple[int, int]]"),
           "Return (channel, number of messages) for each channel that has messages, in order of channels.")
      .def("index", &index_of, "channel"_a, "shift"_a,
           "Return a channel's entries of MCAP's message index, in order, with `shift` added to each offset.")
      .def("messages", &messages, nb::sig("def messages(self) -> list[tuple[int, int, int, bytes]]"),
           "Return each message as (channel, log time [ns], publish time [ns], data).");
}

}  // namespace

void bind_bag(nb::module_& m) {
  bind_chunk(m);
  nb::class_<ChunkSink, Sink>(m, "ChunkSink", "A sink that pushes the samples of a topic into a ChunkQueue.");
  using SimulatedTime = std::optional<std::int64_t>;
  nb::class_<QueueHandle>(m, "ChunkQueue",
                          "Messages of a recording, gathered into chunks: any thread pushes, one takes.\n\n"
                          "A full queue drops messages and counts them; a ring drops its oldest chunks instead.")
      .def(
          "__init__",
          [](QueueHandle* self, std::size_t chunk_size, std::size_t cache_size, std::int64_t duration_ns, bool ring) {
            const ChunkQueue::Limits limits{chunk_size, cache_size, duration_ns, ring};
            new (self) QueueHandle{std::make_shared<ChunkQueue>(limits)};
          },
          "chunk_size"_a, "cache_size"_a, "duration_ns"_a = 0, "ring"_a = false)
      .def("push", &push, "channel"_a, "data"_a, "log_time_ns"_a, "publish_time_ns"_a,
           "Append a message; return False if the queue is paused, closed or full.")
      .def("take", &take, "timeout_ns"_a, nb::sig("def take(self, timeout_ns: int) -> Chunk | None"),
           "Remove and return the oldest complete chunk, or after the timeout the unfinished one; None if there is no "
           "message.")
      .def("wait", &wait, "timeout_ns"_a, "Wait until there is a complete chunk, the queue is closed, or the timeout.")
      .def("seal", &call<&ChunkQueue::seal>, "Complete the unfinished chunk.")
      .def("end_file", &call<&ChunkQueue::end_file>,
           "Complete the unfinished chunk; the next one is the first of a new file.")
      .def("restart_file", &call<&ChunkQueue::restart_file>,
           "Let the next message be the first one of a file, from which its duration counts.")
      .def("close", &call<&ChunkQueue::close>,
           "Store nothing more; `take` then returns what is left, without waiting.")
      .def("set_paused", &call_with<&ChunkQueue::set_paused, bool>, "paused"_a,
           "Set whether messages are discarded, uncounted.")
      .def("set_simulated_time", &call_with<&ChunkQueue::set_simulated_time, SimulatedTime>, "now_ns"_a.none(),
           "Set the log time of samples [ns since epoch]; 0: unknown, none is stored; None: their time of receipt.")
      .def(
          "sink",
          [](const QueueHandle& self, std::uint16_t channel) {
            return std::make_unique<ChunkSink>(self.queue, channel);
          },
          "channel"_a, "Return a sink for `Reader.feed` that pushes a topic's samples with a channel's number.")
      .def_prop_ro("has_chunk", &call<&ChunkQueue::has_chunk>, "Whether a complete chunk is waiting.")
      .def_prop_ro("message_count", &call<&ChunkQueue::message_count>, "Number of messages that were stored.")
      .def_prop_ro("dropped_count", &call<&ChunkQueue::dropped_count>, "Number of messages that a full queue dropped.")
      .def("dropped_counts", &call<&ChunkQueue::dropped_counts>, nb::sig("def dropped_counts(self) -> list[int]"),
           "Return these numbers by channel, from 0 to the last one that has lost a message.")
      .def_prop_ro("size", &call<&ChunkQueue::size>, "Size of what has not been taken [bytes].");
}

}  // namespace tfloom::bindings
