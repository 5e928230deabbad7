"""Topics and the graph on each wire: what `rmw/base.py` promises of all of them."""

from __future__ import annotations

import random
import threading
from array import array
from collections.abc import Callable
from importlib import import_module

import numpy as np
import pytest
from tests.conftest import wait_until
from tests.rmw.conftest import NODES, WIRES, Wires

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.interfaces.sensor_msgs.msg import Image, JointState, LaserScan
from tfloom.interfaces.std_msgs.msg import Float64MultiArray
from tfloom.interfaces.trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from tfloom.rmw.base import Reader, Topic
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS, ReliabilityPolicy
from tfloom.rosidl import cdr
from tfloom.rosidl.message import EncodeError, Message

TOPIC = Topic("/chatter", "std_msgs/msg/String", "RIHS01_" + "1" * 64)
HERE, THERE = NODES
HEADER = b"\0\1\0\0"
LATCHED = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=3)
KEEP_ALL = QoS(history=HistoryPolicy.KEEP_ALL)
WAIT_NS = 30 * 10**9

TakeData = Callable[[Reader, int], list[bytes]]

OTHERWISE = {
    ("another hash", "zenoh"): "the hash of the type is a part of the key",
}
"""What a wire does otherwise than the others, and why."""


def texts(*numbers: int) -> list[bytes]:
    """Return the samples of these numbers, of a size that no wire pads."""
    return [HEADER + b"%08d" % number for number in numbers]


def test_a_sample_bears_the_writers_gid_and_its_stamps(wires: Wires) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    (data,) = texts(1)
    writer.write(data)
    taken = []
    wait_until(lambda: taken.append(reader.take()) or taken[-1])
    sample = taken[-1]
    assert (sample.data, sample.publisher_gid) == (data, writer.gid)
    assert len(writer.gid) == 16
    assert 0 < sample.source_stamp_ns <= sample.received_stamp_ns
    assert reader.take() is None


def test_matched_counts_follow_both_sides(wires: Wires) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    readers = [wire.create_reader(node, TOPIC, QoS()) for wire, node in zip(wires, NODES, strict=True)]
    wait_until(lambda: writer.matched_count() == 2)
    wait_until(lambda: [reader.matched_count() for reader in readers] == [1, 1])
    readers[0].close()
    wait_until(lambda: writer.matched_count() == 1)
    writer.close()
    wait_until(lambda: readers[1].matched_count() == 0)


@pytest.mark.parametrize(
    "topic",
    [TOPIC._replace(name="/other"), TOPIC._replace(type_name="std_msgs/msg/Int32")],
    ids=["name", "type"],
)
def test_another_name_or_type_is_another_topic(wires: Wires, take_data: TakeData, topic: Topic) -> None:
    writer, other_writer = (wires[0].create_writer(HERE, written, QoS()) for written in (TOPIC, topic))
    reader, other = (wires[1].create_reader(THERE, read, QoS()) for read in (TOPIC, topic))
    wait_until(lambda: writer.matched_count() == reader.matched_count() == other.matched_count() == 1)
    wait_until(lambda: other_writer.matched_count() == 1)
    writer.write(texts(1)[0])
    other_writer.write(texts(2)[0])
    assert take_data(other, 1) == texts(2)
    assert take_data(reader, 1) == texts(1)


def test_another_hash_of_a_type_is_the_same_topic(wires: Wires, request: pytest.FixtureRequest) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    same = wires[1].create_reader(THERE, TOPIC, QoS())
    other = wires[1].create_reader(THERE, TOPIC._replace(type_hash="RIHS01_" + "2" * 64), QoS())
    is_apart = ("another hash", request.node.callspec.params["wires"]) in OTHERWISE
    wait_until(lambda: same.matched_count() == 1 and writer.matched_count() == 2 - is_apart)
    assert other.matched_count() == 1 - is_apart


def test_incompatible_qualities_are_matched_where_samples_pass(wires: Wires, take_data: TakeData) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    asks_more = wires[1].create_reader(THERE, TOPIC, LATCHED)
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    writer.write(texts(1)[0])
    assert take_data(reader, 1) == texts(1)
    if wires[1].graph.delivers_incompatible():
        assert take_data(asks_more, 1) == texts(1)
        wait_until(lambda: (writer.matched_count(), asks_more.matched_count()) == (2, 1))
    else:
        assert asks_more.take() is None
        assert (writer.matched_count(), asks_more.matched_count()) == (1, 0)


def test_domains_are_apart(
    wires: Wires, domain_id: int, request: pytest.FixtureRequest, take_data: TakeData
) -> None:
    module = import_module(f"tfloom.rmw.{WIRES[request.node.callspec.params['wires']]}.wire")
    elsewhere = module.open_participant(domain_id + 100)
    try:
        elsewhere.add_node(HERE)
        hears_nothing = elsewhere.create_reader(HERE, TOPIC, QoS())
        writer, near = wires[0].create_writer(HERE, TOPIC, QoS()), wires[1].create_reader(THERE, TOPIC, QoS())
        wait_until(lambda: writer.matched_count() and near.matched_count())
        writer.write(texts(1)[0])
        assert take_data(near, 1) == texts(1)
        assert hears_nothing.take() is None
        assert elsewhere.graph.nodes() == [HERE]
    finally:
        elsewhere.close()


def test_keep_last_drops_the_oldest_and_keep_all_none(wires: Wires, take_data: TakeData) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, KEEP_ALL)
    last = wires[1].create_reader(THERE, TOPIC, QoS(depth=3))
    every = wires[1].create_reader(THERE, TOPIC, KEEP_ALL)
    wait_until(lambda: writer.matched_count() == 2 and last.matched_count() == every.matched_count() == 1)
    for data in texts(*range(50)):
        writer.write(data)
    assert take_data(every, 50) == texts(*range(50))
    # Both have the last sample, but the one may have been told before the other.
    taken: list[bytes] = []
    wait_until(lambda: taken.extend(sample.data for sample in iter(last.take, None)) or texts(49)[0] in taken)
    assert taken == texts(*range(50))[-len(taken) :]
    assert len(taken) <= 2 * 3


def test_late_readers_of_a_transient_local_topic_get_its_last_samples(
    wires: Wires, take_data: TakeData
) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, LATCHED)
    wait_until(lambda: writer.matched_count() == 0)  # a reader of the test before gets no sample of this one
    for data in texts(*range(5)):
        writer.write(data)
    asks = wires[1].create_reader(THERE, TOPIC, LATCHED._replace(depth=10))
    assert take_data(asks, 3) == texts(2, 3, 4)
    volatile = wires[1].create_reader(THERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() == 2 and volatile.matched_count() == 1)
    writer.write(texts(5)[0])
    assert take_data(volatile, 1) == take_data(asks, 1) == texts(5)


def test_a_token_is_posted_for_what_waits_and_for_what_comes(wires: Wires, take_data: TakeData) -> None:
    queue = ReadyQueue()
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    reader.notify(queue, 5)
    writer.write(texts(1)[0])
    wait_until(lambda: queue.wait(WAIT_NS) == [5])
    assert take_data(reader, 1) == texts(1)
    earlier = ReadyQueue()
    reader.notify(earlier, 4)
    writer.write(texts(2)[0])
    wait_until(lambda: earlier.wait(WAIT_NS) == [4])
    reader.notify(queue, 6)
    assert queue.wait(WAIT_NS) == [6]
    reader.notify(None)
    assert take_data(reader, 1) == texts(2)


def test_a_sink_gets_what_waits_and_then_what_comes(wires: Wires) -> None:
    sink = SampleQueue(10)
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    wait_until(lambda: writer.matched_count() and reader.matched_count())
    queue = ReadyQueue()
    reader.notify(queue, 1)
    writer.write(texts(1)[0])
    assert queue.wait(WAIT_NS) == [1]
    reader.feed(sink)
    writer.write(texts(2)[0])
    pushed: list[bytes] = []
    wait_until(lambda: pushed.extend(sample[0] for sample in sink.take()) or len(pushed) == 2)
    assert pushed == texts(1, 2)
    assert reader.take() is None
    assert queue.wait(0) == []
    reader.close()
    writer.write(texts(3)[0])
    assert sink.take() == []


def test_writers_on_many_threads_lose_and_swap_none(wires: Wires, take_data: TakeData) -> None:
    reader = wires[1].create_reader(THERE, TOPIC, KEEP_ALL)
    writers = [wires[0].create_writer(HERE, TOPIC, KEEP_ALL) for _ in range(4)]
    wait_until(lambda: reader.matched_count() == 4 and all(writer.matched_count() for writer in writers))
    threads = [
        threading.Thread(
            target=lambda number=number, writer=writer: [
                writer.write(data) for data in texts(*range(1000 * number, 1000 * number + 100))
            ]
        )
        for number, writer in enumerate(writers)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    taken = [int(data[4:]) for data in take_data(reader, 400)]
    for number in range(4):
        mine = [value for value in taken if value // 1000 == number]
        assert mine == list(range(1000 * number, 1000 * number + 100))


def test_what_is_closed_delivers_and_writes_nothing(wires: Wires) -> None:
    writer = wires[0].create_writer(HERE, TOPIC, QoS())
    reader = wires[1].create_reader(THERE, TOPIC, QoS())
    writer.write(texts(1)[0])
    wait_until(lambda: reader.matched_count() == writer.matched_count() == 1)
    for end in (reader, writer):
        end.close()
        end.close()
        assert end.matched_count() == 0
    assert reader.take() is None
    with pytest.raises(ClosedError, match=r"cannot write to /chatter: (its|the) writer is closed"):
        writer.write(texts(1)[0])
    wires[0].close()
    with pytest.raises(ClosedError):
        wires[0].create_writer(HERE, TOPIC, QoS())


def test_the_graph_has_nodes_and_endpoints_of_others_and_loses_them(wires: Wires) -> None:
    graph, queue = wires[0].graph, ReadyQueue()
    wait_until(lambda: graph.nodes() == [THERE, HERE])  # in order of their full names
    graph.notify(queue, 3)
    before = graph.changes()
    reader = wires[1].create_reader(THERE, TOPIC, QoS(ReliabilityPolicy.SYSTEM_DEFAULT, depth=7))
    wait_until(lambda: [end.gid for end in graph.endpoints()] == [reader.gid])
    (info,) = graph.endpoints()
    assert (info.topic.name, info.topic.type_name, info.is_writer) == (TOPIC.name, TOPIC.type_name, False)
    assert (info.qos.reliability, info.qos.depth) == (ReliabilityPolicy.RELIABLE, 7)
    wait_until(lambda: graph.endpoints()[0].node == THERE)
    assert graph.changes() > before
    assert 3 in queue.wait(WAIT_NS)
    wires[1].close()
    wait_until(lambda: graph.nodes() == [HERE] and graph.endpoints() == [])


def large_messages() -> list[Message]:
    """Return messages whose arrays are larger than what a wire copies twice, at each alignment, and one without."""
    octets, reals = random.Random(1).randbytes(300_001), array("d", range(20_000))
    joints = [JointState(name=["j" * length], position=reals, effort=reals[:1]) for length in range(1, 9)]
    plan = JointTrajectory(
        points=[
            JointTrajectoryPoint(positions=reals, velocities=reals[:3], accelerations=reals) for _ in range(9)
        ]
    )
    numbers = Float64MultiArray(data=np.arange(30_000.0)[::-1].tolist())
    names = JointState(name=["a name"] * 30_000)
    return [Image(encoding="rgb8", data=octets), *joints, plan, numbers, names, Image(data=octets[:3])]


def large_topic(message: Message) -> Topic:
    return Topic("/large", f"{type(message).__name__}/msg/Any", TOPIC.type_hash)


def test_large_messages_are_written_as_they_are_encoded(wires: Wires, take_data: TakeData) -> None:
    for message in large_messages():
        writer = wires[0].create_writer(HERE, large_topic(message), KEEP_ALL)
        reader = wires[1].create_reader(THERE, large_topic(message), KEEP_ALL)
        wait_until(lambda end=writer: end.matched_count() == 1)
        # The first of a class is written as the second where the size of the last one is not yet known.
        for _ in range(2):
            writer.write_message(message)
        encoded = cdr.encode(message)
        for data in take_data(reader, 2):
            assert data[: len(encoded)] == encoded
            assert data[len(encoded) :] == bytes(-len(encoded) % 4)[: len(data) - len(encoded)]
        writer.close()
        reader.close()


def test_arrays_of_written_messages_can_grow_again(wires: Wires) -> None:
    message = Image(data=bytes(300_000))
    cdr.encode(message)
    writer = wires[0].create_writer(HERE, large_topic(message), QoS())
    writer.write_message(message)
    message.data.append(1)
    message.encoding = 5  # after which the array comes
    with pytest.raises(EncodeError, match=r"Image\.encoding must be a str"):
        writer.write_message(message)
    message.data.append(2)
    scan = LaserScan(ranges=array("f", bytes(800_000)))
    cdr.encode(scan)
    scan.range_max = Raises()
    scans = wires[0].create_writer(HERE, large_topic(scan), QoS())
    with pytest.raises(RuntimeError, match="a value's own error"):
        scans.write_message(scan)
    scan.ranges.append(1.0)
    message.encoding = ""
    writer.close()
    with pytest.raises(ClosedError):
        writer.write_message(message)
    message.data.append(3)
    assert message.data[-3:].tolist() == [1, 2, 3]


class Raises:
    def __float__(self) -> float:
        raise RuntimeError("a value's own error")
