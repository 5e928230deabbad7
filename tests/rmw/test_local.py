"""The in-process wire: matching, order of samples, and the graph."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import pytest

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.local import LocalParticipant, LocalReader, open_participant
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS, ReliabilityPolicy

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


def test_matched_counts_follow_both_endpoints(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    assert writer.matched_count() == 0
    readers = [end.create_reader(LISTENER, TOPIC, QoS()) for end in ends]
    assert (writer.matched_count(), readers[0].matched_count(), readers[1].matched_count()) == (2, 1, 1)
    readers[0].close()
    assert writer.matched_count() == 1
    writer.close()
    assert readers[1].matched_count() == 0


@pytest.mark.parametrize(
    ("topic", "qos"),
    [
        (TOPIC._replace(name="/other"), QoS()),
        (TOPIC._replace(type_name="std_msgs/msg/Int32"), QoS()),
        (TOPIC, QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)),
    ],
    ids=["name", "type", "qos"],
)
def test_other_topics_types_and_qualities_do_not_match(ends, topic: Topic, qos: QoS) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, topic, qos)
    writer.write(b"data")
    assert (writer.matched_count(), reader.matched_count(), reader.take()) == (0, 0, None)


def test_another_hash_of_the_type_still_matches(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    ends[1].create_reader(LISTENER, TOPIC._replace(type_hash=""), QoS())
    assert writer.matched_count() == 1


def test_domains_are_separate(ends) -> None:
    elsewhere = open_participant(8)
    reader = elsewhere.create_reader(LISTENER, TOPIC, QoS())
    ends[0].create_writer(TALKER, TOPIC, QoS()).write(b"data")
    assert reader.take() is None
    assert elsewhere.graph.nodes() == []
    elsewhere.close()


def test_keep_last_drops_the_oldest_and_keep_all_none(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    last = ends[1].create_reader(LISTENER, TOPIC, QoS(depth=3))
    every = ends[1].create_reader(LISTENER, TOPIC, QoS(history=HistoryPolicy.KEEP_ALL, depth=1))
    sent = [b"%d" % i for i in range(10)]
    for data in sent:
        writer.write(data)
    assert drain(last) == sent[-3:]
    assert drain(every) == sent


def test_late_reader_receives_the_samples_of_a_transient_local_writer(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, TRANSIENT_LOCAL)
    for i in range(5):
        writer.write(b"%d" % i)
    asks = ends[1].create_reader(LISTENER, TOPIC, TRANSIENT_LOCAL._replace(depth=10))
    does_not = ends[1].create_reader(LISTENER, TOPIC, QoS())
    assert drain(asks) == [b"2", b"3", b"4"]
    assert drain(does_not) == []
    writer.write(b"5")
    assert drain(asks) == drain(does_not) == [b"5"]


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


def test_closed_endpoint_delivers_nothing_and_close_is_idempotent(ends) -> None:
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    writer.write(b"data")
    reader.close()
    reader.close()
    assert reader.take() is None
    writer.close()
    writer.close()
    with pytest.raises(ClosedError, match="/chatter"):
        writer.write(b"data")


def test_graph_lists_nodes_and_endpoints_of_all_participants(ends) -> None:
    graph = ends[0].graph
    ends[0].add_node(TALKER)
    ends[1].add_node(LISTENER)
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS(reliability=ReliabilityPolicy.SYSTEM_DEFAULT))
    assert graph.nodes() == [LISTENER, TALKER]
    (info,) = graph.endpoints()
    assert (info.topic, info.node, info.is_writer, info.gid) == (TOPIC, LISTENER, False, reader.gid)
    assert info.qos.reliability == ReliabilityPolicy.RELIABLE
    ends[1].close()
    assert graph.nodes() == [TALKER]
    assert graph.endpoints() == []


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


def test_closed_participant_opens_nothing(ends) -> None:
    ends[0].close()
    ends[0].close()
    with pytest.raises(ClosedError):
        ends[0].create_writer(TALKER, TOPIC, QoS())


def test_writers_on_many_threads_lose_no_sample(ends) -> None:
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS(history=HistoryPolicy.KEEP_ALL))
    writers = [ends[0].create_writer(TALKER, TOPIC, QoS()) for _ in range(4)]
    threads = [
        threading.Thread(target=lambda w=writer: [w.write(b"%d" % i) for i in range(500)])
        for writer in writers
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    samples = list(iter(reader.take, None))
    for writer in writers:
        mine = [int(sample.data) for sample in samples if sample.publisher_gid == writer.gid]
        assert mine == list(range(500))


def test_sink_receives_waiting_samples_first_and_take_none(ends) -> None:
    queue, sink = ReadyQueue(), SampleQueue(10)
    writer = ends[0].create_writer(TALKER, TOPIC, QoS())
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    reader.notify(queue, 1)
    writer.write(b"1")
    reader.feed(sink)
    assert queue.wait(0) == [1]
    writer.write(b"2")
    writer.write(b"3")
    assert [sample[0] for sample in sink.take()] == [b"1", b"2", b"3"]
    assert reader.take() is None
    assert queue.wait(0) == []
    reader.close()
    writer.write(b"4")
    assert sink.take() == []


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


def test_sink_that_comes_later_receives_what_waits_at_once(ends) -> None:
    sink = SampleQueue(10)
    reader = ends[1].create_reader(LISTENER, TOPIC, QoS())
    ends[0].create_writer(TALKER, TOPIC, QoS()).write(b"1")
    reader.feed(sink)
    assert [sample[0] for sample in sink.take()] == [b"1"]


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
