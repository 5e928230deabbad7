"""What is said of a live graph's publishers, on the local wire: each cause of a failure by itself."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace

import pytest
from tests.tf2_tools.recordings import recorded, transform

from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rmw.base import NodeName, Participant, Writer
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import QoS, ReliabilityPolicy
from tfloom.rmw.typed_names import topic_of
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.lookups.advice import advise
from tfloom.tf2_tools.lookups.lookup import Lookup, Outcome, look_up
from tfloom.tf2_tools.watch.live import LiveWatch

S = 1_000_000_000
DRIVER, WATCHER = NodeName("/", "driver"), NodeName("/", "_watcher")


class Graph:
    """A domain inside the process, with a watch and its buffer."""

    def __init__(self, participant: Participant, cache_s: float) -> None:
        self.participant = participant
        self.buffer = Buffer(int(cache_s * S))
        self.watch = LiveWatch(participant, WATCHER, buffer=self.buffer)

    def writer(self, topic: str = "/tf", qos: QoS | None = None) -> Writer:
        """Open a writer of the driver, of which the watch knows."""
        writer = self.participant.create_writer(DRIVER, topic_of(TFMessage, topic), qos or QoS())
        self.watch.observation()
        return writer

    def lookup(
        self,
        target: str,
        source: str,
        *,
        asked_ns: int = 0,
        now_ns: int | None = None,
        taken_ns: int | None = None,
    ) -> Lookup:
        """Look up at a time; `now_ns` replaces the time, and that of the observation unless `taken_ns` does."""
        seen, taken_ns = self.watch.observation(), taken_ns or now_ns
        return look_up(
            seen if taken_ns is None else replace(seen, taken_ns=taken_ns),
            self.buffer,
            target,
            source,
            asked_ns=asked_ns,
            now_ns=time.time_ns() if now_ns is None else now_ns,
            cache_time_ns=self.buffer.cache_time_ns,
        )


@pytest.fixture
def graph() -> Iterator[Graph]:
    with closing(local.open_participant(0, "/")) as participant:
        participant.add_node(DRIVER)
        participant.add_node(WATCHER)
        opened = Graph(participant, 1.0)
        with closing(opened.watch):
            yield opened


def send(writer: Writer, parent: str, child: str, stamp_ns: int) -> None:
    """Send one transform."""
    writer.write(recorded(0, transform(parent, child, stamp_ns))[2])


def drive(writer: Writer, *, late_s: float = 0.0, length_s: float = 0.5) -> int:
    """Send odom -> base ten times at even stamps that end now, or some time before; return the last stamp."""
    last_ns = time.time_ns() - int(late_s * S)
    for step in range(10):
        send(writer, "odom", "base", last_ns - int(length_s * S) * (9 - step) // 9)
    return last_ns


def said(lookup: Lookup) -> str:
    """Return all sentences on a lookup."""
    return " ".join(advise(lookup))


def test_a_publisher_that_left(graph: Graph) -> None:
    writer = graph.writer()
    last_ns = drive(writer)
    writer.close()
    lookup = graph.lookup("odom", "base", asked_ns=last_ns + S, now_ns=last_ns + 2 * S)
    assert lookup.outcome == Outcome.FUTURE
    assert "/driver has left" in said(lookup)
    assert "start it again" in said(lookup)


def test_a_publisher_that_is_silent(graph: Graph) -> None:
    last_ns = drive(graph.writer())
    received_ns = time.time_ns()  # or some milliseconds before
    text = said(graph.lookup("odom", "base", asked_ns=last_ns + S, now_ns=received_ns + 8 * S))
    assert "/driver has sent none for 8.0" in text
    assert "check that it works" in text


def test_a_publisher_that_is_in_time(graph: Graph) -> None:
    last_ns = drive(graph.writer())
    text = said(graph.lookup("odom", "base", asked_ns=last_ns + S // 100, now_ns=last_ns + S // 50))
    assert "/driver sends one each 0.056 s" in text
    assert "Give the lookup a timeout of" in text


def test_stamps_that_are_far_behind(graph: Graph) -> None:
    last_ns = drive(graph.writer(), late_s=3.0)
    text = said(graph.lookup("odom", "base", asked_ns=last_ns + 2 * S))
    assert "behind their receipt: compare the clocks of both machines" in text


def test_a_time_ahead_of_now(graph: Graph) -> None:
    last_ns = drive(graph.writer())
    text = said(graph.lookup("odom", "base", asked_ns=last_ns + 4 * S, now_ns=last_ns + S))
    assert "The requested time is 3.00 s ahead of now" in text


def test_stamps_of_a_simulation(graph: Graph) -> None:
    writer = graph.writer()
    for second in (11, 12):
        send(writer, "odom", "base", second * S)
    text = said(graph.lookup("odom", "base", asked_ns=time.time_ns()))
    assert "Its stamps are those of a simulation: give -s (--use-sim-time)." in text


def test_a_history_that_is_full_and_one_that_has_just_begun(graph: Graph) -> None:
    writer = graph.writer()
    last_ns = drive(writer)
    begun = said(graph.lookup("odom", "base", asked_ns=last_ns - 5 * S))
    assert "This command has listened for" in begun
    drive(writer, length_s=0.999)
    full = graph.lookup("odom", "base", asked_ns=last_ns - 5 * S)
    assert full.outcome == Outcome.PAST
    assert (
        "A buffer keeps 1.00 s: create it with a longer history, for example Buffer(cache_time=Duration(seconds="
        in said(full)
    )


def test_a_publisher_that_listeners_do_not_receive(graph: Graph) -> None:
    writer = graph.writer(qos=QoS(reliability=ReliabilityPolicy.BEST_EFFORT))
    drive(writer)
    lookup = graph.lookup("odom", "base")
    assert lookup.outcome == Outcome.UNKNOWN_FRAME
    assert "/driver publishes it on /tf, but transform listeners receive nothing from there" in said(lookup)
    assert "publish with RELIABLE." in said(lookup)


def test_a_graph_where_nothing_came(graph: Graph) -> None:
    assert "nobody publishes any" in said(graph.lookup("odom", "base"))
    graph.writer()
    assert "there are publishers: /driver on /tf" in said(graph.lookup("odom", "base"))


def test_a_root_whose_publisher_has_left(graph: Graph) -> None:
    send(graph.writer(), "map", "odom", time.time_ns())
    gone = graph.writer()
    send(gone, "odom", "base", time.time_ns())
    send(graph.writer(), "other", "camera", time.time_ns())
    text = said(graph.lookup("map", "camera"))
    assert "'camera' is in the tree of 'other' (2 frames), and 'map' in that of 'map' (3 frames)" in text


def test_silence_is_measured_by_the_clock_of_receipts(graph: Graph) -> None:
    simulated_ns = 100 * S
    writer = graph.writer()
    for step in range(10):
        send(writer, "odom", "base", simulated_ns + step * S // 20)
    later_ns, taken_ns = simulated_ns + S, time.time_ns() + 8 * S
    lookup = graph.lookup("odom", "base", asked_ns=later_ns, now_ns=later_ns, taken_ns=taken_ns)
    assert lookup.outcome == Outcome.FUTURE
    assert "/driver has sent none for 8.0" in said(lookup)
