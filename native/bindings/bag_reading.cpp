// The records of recordings: listed, or stored in a buffer.
#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bag/mcap_records.hpp"
#include "bag/tf_records.hpp"
#include "bindings/bindings.hpp"
#include "bindings/gil.hpp"
#include "bindings/tf2_buffer.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using bag::Form;
using bag::MessageRecord;
using bag::Record;
using bag::RecordReader;
using bag::TfInserter;

std::span<const std::byte> span_of(const nb::bytes& data) {
  return {static_cast<const std::byte*>(data.data()), data.size()};
}

[[noreturn]] void raise_value_error(const bag::RecordError& error) {
  const nb::object exception = nb::steal(PyObject_CallFunction(PyExc_ValueError, "s", error.what()));
  exception.attr("offset") = error.offset;
  PyErr_SetObject(PyExc_ValueError, exception.ptr());
  throw nb::python_error();
}

// Call `function` without the GIL; raise ValueError for a RecordError.
template <class Function>
auto without_gil(Function&& function) {
  try {
    const ReleasedGil release;
    return function();
  } catch (const bag::RecordError& error) {
    raise_value_error(error);
  }
}

using Channels = std::vector<bool>;

Channels channels_of(const nb::object& wanted) {
  if (wanted.is_none()) return Channels(1 << 16, true);
  Channels channels(1 << 16, false);
  for (const nb::handle channel : nb::borrow<nb::iterable>(wanted)) channels[nb::cast<std::uint16_t>(channel)] = true;
  return channels;
}

nb::list list_messages(const nb::bytes& data, const nb::object& wanted, std::uint64_t start, std::uint64_t end) {
  const Channels channels = channels_of(wanted);
  const auto records = without_gil([bytes = span_of(data), &channels, start, end] {
    std::vector<MessageRecord> messages;
    RecordReader reader(bytes, 0);
    while (reader.advance()) {
      if (!reader.is_message()) continue;
      const MessageRecord message = reader.message();
      if (channels[message.channel] && message.log_time >= start && message.log_time <= end) {
        messages.push_back(message);
      }
    }
    reader.require_end();
    return messages;
  });
  nb::list messages;
  for (const MessageRecord& message : records) {
    messages.append(
        nb::make_tuple(message.log_time, message.channel, message.publish_time, message.offset, message.size));
  }
  return messages;
}

nb::tuple summarise(const nb::bytes& data, std::size_t begin) {
  const bag::RunSummary summary =
      without_gil([bytes = span_of(data), begin] { return bag::summarise(bytes, begin); });
  nb::dict counts;
  for (const auto& [channel, count] : summary.counts) counts[nb::int_(channel)] = count;
  nb::list others;
  for (const Record& record : summary.others) others.append(nb::make_tuple(record.opcode, record.offset, record.size));
  return nb::make_tuple(counts, summary.first, summary.last, others, summary.end);
}

nb::tuple summarise_indexes(const nb::bytes& data) {
  const bag::IndexSummary found = without_gil([bytes = span_of(data)] { return bag::summarise_indexes(bytes); });
  return nb::make_tuple(found.count, found.first, found.last);
}

// Stores the recorded messages of several topics in a buffer.
class TfRecords {
 public:
  explicit TfRecords(const BufferHandle& handle) : buffer_(handle.buffer) {}

  std::size_t add_topic(std::string name, bool is_static, bool is_ros1) {
    inserters_.emplace_back(*buffer_, std::move(name), is_static, is_ros1 ? Form::ros1 : Form::cdr);
    return inserters_.size() - 1;
  }

  void insert(std::size_t topic, const nb::bytes& message) {
    TfInserter& inserter = inserters_.at(topic);
    inserter.insert(span_of(message));
    inserter.finish();
  }

  std::size_t insert_mcap(const nb::bytes& data, const std::vector<std::pair<std::uint16_t, std::size_t>>& channels,
                          std::uint64_t start, std::uint64_t end) {
    std::vector<TfInserter*> of_channel(1 << 16, nullptr);
    for (const auto& [channel, topic] : channels) of_channel[channel] = &inserters_.at(topic);
    return without_gil([this, bytes = span_of(data), &of_channel, start, end] {
      std::size_t next = 0;
      try {
        next = insert_records(bytes, of_channel, start, end);
      } catch (const bag::RecordError&) {
        finish();  // because the transforms' names are views into the bytes
        throw;
      }
      finish();
      return next;
    });
  }

  [[nodiscard]] std::uint64_t message_count() const { return sum(&TfInserter::message_count); }
  [[nodiscard]] std::uint64_t dropped_count() const { return sum(&TfInserter::dropped_count); }

 private:
  static std::size_t insert_records(std::span<const std::byte> bytes, const std::vector<TfInserter*>& of_channel,
                                    std::uint64_t start, std::uint64_t end) {
    RecordReader reader(bytes, 0);
    while (reader.advance()) {
      if (!reader.is_message()) continue;
      const MessageRecord message = reader.message();
      TfInserter* inserter = of_channel[message.channel];
      if (inserter == nullptr) continue;
      if (!inserter->is_static() && (message.log_time < start || message.log_time > end)) continue;
      inserter->insert(bytes.subspan(message.offset, message.size));
    }
    return reader.next();
  }

  void finish() {
    for (TfInserter& inserter : inserters_) inserter.finish();
  }

  [[nodiscard]] std::uint64_t sum(std::uint64_t (TfInserter::*count)() const) const {
    std::uint64_t total = 0;
    for (const TfInserter& inserter : inserters_) total += (inserter.*count)();
    return total;
  }

  std::shared_ptr<tf2::Buffer> buffer_;
  std::vector<TfInserter> inserters_;  // used by one thread at a time
};

}  // namespace

void bind_bag_reading(nb::module_& m) {
  m.def("list_mcap_messages", &list_messages, "data"_a, "channels"_a.none(), "start_ns"_a, "end_ns"_a,
        nb::sig("def list_mcap_messages(data: bytes, channels: collections.abc.Iterable[int] | None, start_ns: int, "
                "end_ns: int) -> list[tuple[int, int, int, int, int]]"),
        "Return the messages among the MCAP records in `data`, of `channels` (None: all) and with log times from "
        "`start_ns` to `end_ns`.\n\n"
        "Each is log time [ns], channel, publish time [ns], and the offset and size of its bytes in `data`. Raises "
        "ValueError, with the record's `offset`, if a record is not whole.");
  m.def("summarise_mcap", &summarise, "data"_a, "begin"_a,
        nb::sig("def summarise_mcap(data: bytes, begin: int) -> tuple[dict[int, int], int, int, list[tuple[int, int, "
                "int]], int]"),
        "Return what the messages, schemas and channels are that follow each other in `data` from `begin` on.\n\n"
        "They are: the count of messages by channel; the least and the greatest log time [ns]; opcode, offset and size "
        "of each other record's content; and the offset of the first record that is of another kind or not whole. "
        "Raises ValueError, with the record's `offset`, if a message record is too short.");
  m.def("summarise_mcap_indexes", &summarise_indexes, "data"_a,
        nb::sig("def summarise_mcap_indexes(data: bytes) -> tuple[int, int, int]"),
        "Return count, least and greatest log time [ns] of the messages that the message index records in `data` name. "
        "Raises ValueError, with the record's `offset`, if a record is another or not whole.");
  nb::class_<TfRecords>(m, "TfRecords", "Stores recorded TFMessages in a buffer, without message objects. It must be "
                                        "used by one thread at a time.")
      .def(nb::init<const BufferHandle&>(), "buffer"_a)
      .def("add_topic", &TfRecords::add_topic, "name"_a, "static"_a, "ros1"_a,
           "Return the number of a topic, whose name becomes the authority of its transforms.")
      .def("insert", &TfRecords::insert, "topic"_a, "data"_a, "Store a message of a topic.")
      .def("insert_mcap", &TfRecords::insert_mcap, "data"_a, "channels"_a, "start_ns"_a, "end_ns"_a,
           "Store the messages among the MCAP records in `data`. Return where the first record begins that is not "
           "whole, or the length of `data`.\n\n"
           "`channels` are pairs of a channel and a topic's number. Messages of moving transforms are stored if their "
           "log time is from `start_ns` to `end_ns`. Raises ValueError, with the record's `offset`, if a message record "
           "is too short.")
      .def_prop_ro("message_count", &TfRecords::message_count, "Number of messages.")
      .def_prop_ro("dropped_count", &TfRecords::dropped_count, "Number of unreadable messages, which were logged.");
}

}  // namespace tfloom::bindings
