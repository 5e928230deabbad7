// The queues of an executor, sinks, and the waits of threads.

#include <nanobind/nanobind.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "bindings/bindings.hpp"
#include "bindings/gil.hpp"
#include "bindings/bytes.hpp"
#include "bindings/signal_wakeup.hpp"
#include "core/ready_queue.hpp"
#include "core/sample_queue.hpp"
#include "core/sink.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

Gid gid_of_publisher(const nb::bytes& bytes) { return bytes_of<16>(bytes, "publisher_gid must have 16 bytes"); }

std::vector<ReadyQueue::Token> wait_for_tokens(ReadyQueue& queue, std::int64_t timeout_ns, bool quiet) {
  std::vector<ReadyQueue::Token> tokens;
  if (queue.take(tokens, quiet)) return tokens;
  if (timeout_ns == 0) {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    return tokens;
  }
  const Waker::Deadline deadline(timeout_ns);
  for (;;) {
    const SignalWakeup signals;  // before the check, so that a signal after it ends the wait
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    const GilReleasedForWait release;
    const auto left = deadline.left();
    const auto outcome = queue.wait(left ? left->count() : -1, tokens, quiet, signals.fd());
    if (outcome != ReadyQueue::Outcome::interrupted) return tokens;
  }
}

nb::list take_samples(SampleQueue& queue) {
  nb::list taken;
  for (const auto& [data, info] : queue.take()) {
    taken.append(nb::make_tuple(nb::bytes(data.data(), data.size()), info.source_stamp_ns, info.received_stamp_ns,
                                nb::bytes(info.publisher_gid.data(), info.publisher_gid.size())));
  }
  return taken;
}

}  // namespace

void bind_core(nb::module_& m) {
  count_threads_anew_in_forks();
  m.def("block_waits_at_exit", &block_waits_at_exit,
        "Block every other thread for ever at the end of its wait, and where Python would end it, from now on.\n\n"
        "Called at the end of the program, because Python would end threads inside native calls, and the process with "
        "them. Registered with `atexit`; calling it again does nothing.");
  m.def("block_if_ending", &block_if_ending,
        "Block this thread for ever if `block_waits_at_exit` was called on another one.");
  nb::module_::import_("atexit").attr("register")(m.attr("block_waits_at_exit"));

  nb::class_<Sink>(m, "Sink", "A receiver of serialized samples that needs no Python; see `Reader.feed`.")
      .def(
          "push",
          [](Sink& sink, const nb::bytes& data, std::int64_t source_stamp_ns, std::int64_t received_stamp_ns,
             const nb::bytes& publisher_gid) {
            const SampleInfo info{source_stamp_ns, received_stamp_ns, gid_of_publisher(publisher_gid)};
            const std::span view(static_cast<const std::byte*>(data.data()), data.size());
            const ReleasedGil release;
            sink.push(view, info);
          },
          "data"_a, "source_stamp_ns"_a, "received_stamp_ns"_a, "publisher_gid"_a,
          "Push one sample: encapsulation header and CDR, stamps [ns since epoch], 16 bytes of gid.")
      .def(
          "forget", [](Sink& sink, const nb::bytes& publisher_gid) { sink.forget(gid_of_publisher(publisher_gid)); },
          "publisher_gid"_a, "Forget what is stored for a publisher that has left.")
      .def("notify", &Sink::notify, "queue"_a.none(), "token"_a,
           "Post `token` to `queue` after a push, for waits with `quiet` only; None ends it.\n\n"
           "Post at once if there was a push since `take_pushed`.")
      .def("take_pushed", &Sink::take_pushed, "Return whether a sample was pushed since the last call.");

  nb::class_<SampleQueue, Sink>(m, "SampleQueue",
                                "A sink that stores the newest samples until Python takes them.")
      .def(nb::init<std::size_t>(), "depth"_a)
      .def("take", &take_samples, nb::sig("def take(self) -> list[tuple[bytes, int, int, bytes]]"),
           "Remove and return all samples, each as (data, source stamp, received stamp, gid).")
      .def("pushed", &SampleQueue::pushed, "Return how many samples have ever been pushed.");

  nb::class_<ReadyQueue>(m, "ReadyQueue",
                         "A queue of tokens of entities that are ready: any thread may post, one thread waits.")
      .def(nb::new_([] { return std::make_shared<ReadyQueue>(); }))  // so that C++ shares it without Python
      .def("post", &ReadyQueue::post, "token"_a, nb::call_guard<ReleasedGil>(),
           "Post a token. A token that is posted again before it is taken is taken once.")
      .def("wait", &wait_for_tokens, "timeout_ns"_a, "quiet"_a = false,
           "Wait for tokens and take all of them, in order of first posting; tokens of sinks only if `quiet`.\n\n"
           "Does not wait if the timeout is 0, and waits without limit if it is negative. Returns an empty list on a "
           "timeout. Releases the GIL. A signal's Python handler runs at once, and its exception is raised here.");
}

}  // namespace tfloom::bindings
