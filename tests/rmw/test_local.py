"""The in-process wire: what it promises beyond what `test_topics` checks of each wire."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import pytest

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.local.wire import LocalParticipant, LocalReader, open_participant
from tfloom.rmw.qos import DurabilityPolicy, QoS

TOPIC = Topic("/chatter", "std_msgs/msg/String", "RIHS01_" + "0" * 64)
TALKER = NodeName("/", "talker")
LISTENER = NodeName("/a/b", "listener")
TRANSIENT_LOCAL = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=3)


@pytest.fixture
def ends(request: pytest.FixtureRequest) -> Iterator[tuple[LocalParticipant, LocalParticipant]]:
    here, there = open_participant(7), open_participant(7)
    yield here, there
    here.close()
    there.close()


def drain(reader: LocalReader) -> list[bytes]:
    samples = iter(reader.take, None)
    return [sample.data for sample in samples]


def test_sample_is_delivered_before_write_returns(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    writer.write(b"\0\1\0\0abcd")
    sample = reader.take()
    assert sample is not None
    assert sample.data == b"\0\1\0\0abcd"
    assert sample.publisher_gid == writer.gid
    assert len(writer.gid) == 16
    assert 0 < sample.source_stamp_ns <= sample.received_stamp_ns
    assert reader.take() is None


def test_a_sample_past_its_lifespan_is_not_taken(ends, wait_until) -> None:
    brief = TRANSIENT_LOCAL._replace(lifespan_ns=1_000)
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    ends[0].create_writer(TALKER, TOPIC, brief).write(b"data")
    wait_until(lambda: reader.take() is None)
    assert drain(ends[1].create_reader(LISTENER, TOPIC, TRANSIENT_LOCAL)) == []


def test_notify_posts_at_once_for_waiting_samples_and_for_each_later_one(ends) -> None:
    queue = ReadyQueue()
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    reader.notify(queue, 5)
    assert queue.wait(0) == []
    writer.write(b"1")
    assert queue.wait(0) == [5]
    reader.notify(queue, 6)
    assert queue.wait(0) == [6]
    reader.notify(None)
    writer.write(b"2")
    assert queue.wait(0) == []


def test_graph_changes_are_counted_and_posted(ends) -> None:
    queue = ReadyQueue()
    before = ends[0].graph.changes()
    ends[0].graph.notify(queue, 3)
    ends[1].add_node(LISTENER)
    assert ends[0].graph.changes() > before
    assert queue.wait(0) == [3]
    ends[0].graph.notify(None)
    ends[1].remove_node(LISTENER)
    assert queue.wait(0) == []


def test_a_sink_is_fed_no_sample_past_its_lifespan(ends, wait_until) -> None:
    sink = SampleQueue(10)
    brief = ends[0].create_writer(TALKER, TOPIC, TRANSIENT_LOCAL._replace(lifespan_ns=1_000))
    brief.write(b"old")
    probe = ends[1].create_reader(LISTENER, TOPIC, TRANSIENT_LOCAL)
    wait_until(lambda: probe.take() is None)
    ends[1].create_reader(LISTENER, TOPIC, TRANSIENT_LOCAL).feed(sink)
    assert sink.pushed() == 0


class Received:
    """A sink that calls a function with each sample's bytes, and another one for each writer that has left."""

    def __init__(
        self,
        on_push: Callable[[bytes], object] = lambda _: None,
        on_forget: Callable[[bytes], object] = lambda _: None,
    ) -> None:
        self.pushed: list[bytes] = []
        self.forgotten: list[bytes] = []
        self._on_push = on_push
        self._on_forget = on_forget

    def push(self, data: bytes, *_: object) -> None:
        self.pushed.append(data)
        self._on_push(data)

    def forget(self, gid: bytes) -> None:
        self.forgotten.append(gid)
        self._on_forget(gid)


def on_a_thread(function: Callable[[], object]) -> None:
    thread = threading.Thread(target=function)
    thread.start()
    thread.join()


def test_sink_forgets_a_writer_that_leaves(ends) -> None:
    sink = Received()
    writers = [ends[0].create_writer(TALKER, TOPIC, QoS()) for _ in range(2)]
    ends[1].create_reader(LISTENER, TOPIC, QoS()).feed(sink)
    writers[0].close()
    assert sink.forgotten == [writers[0].gid]


def test_error_of_a_sink_loses_no_other_sample(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())

    def fail_at_first(data: bytes) -> None:
        if data == b"1":
            on_a_thread(lambda: writer.write(b"2"))  # leaves its sample to this thread
            raise ValueError("first")

    sink = Received(fail_at_first)
    ends[1].create_reader(LISTENER, TOPIC, QoS()).feed(sink)
    with pytest.raises(ValueError, match="first"):
        writer.write(b"1")
    assert sink.pushed == [b"1", b"2"]
    on_a_thread(lambda: writer.write(b"3"))
    assert sink.pushed == [b"1", b"2", b"3"]


def test_reader_that_opens_while_a_writer_leaves_does_not_match_it(ends) -> None:
    late: list[LocalReader] = []
    open_another = lambda _: late.append(ends[1].create_reader(LISTENER, TOPIC, QoS()))  # noqa: E731
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    ends[1].create_reader(LISTENER, TOPIC, QoS()).feed(Received(on_forget=open_another))
    writer.close()
    assert [reader.matched_count() for reader in late] == [0]


def test_reader_that_its_sink_closes_gives_no_more_samples(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    for data in (b"1", b"2", b"3"):
        writer.write(data)
    sink, later = Received(lambda _: reader.close()), Received()
    reader.feed(sink)
    assert sink.pushed == [b"1"]
    reader.feed(later)
    assert later.pushed == []


_left_open: list[LocalParticipant] = []


@pytest.mark.parametrize("turn", ["first", "second"])
def test_a_participant_that_a_test_left_open_is_not_on_the_domain_of_the_next(turn: str) -> None:
    _left_open.append(open_participant(0))
    _left_open[-1].add_node(NodeName("/", turn))
    assert [node.name for node in _left_open[-1].graph.nodes()] == [turn]
    if turn == "second":
        for participant in _left_open:
            participant.close()
