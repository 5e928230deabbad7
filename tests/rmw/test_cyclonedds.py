"""DDS between two processes, each with the endpoints of all tests: unchanged bytes, qualities of service."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator

import pytest
from tests.conftest import Program
from tests.rmw.conftest import Peer, peers

from tfloom._native import ReadyQueue, SampleQueue
from tfloom.interfaces.std_msgs.msg import UInt8MultiArray
from tfloom.rmw.base import NodeName, Participant, Sample, Topic
from tfloom.rmw.cyclone.wire import open_participant
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy
from tfloom.rosidl import cdr

HEADER = b"\0\1\0\0"
KEEP_ALL = QoS(history=HistoryPolicy.KEEP_ALL)
TRANSIENT_LOCAL = QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL, depth=5)
BEST_EFFORT = QoS(reliability=ReliabilityPolicy.BEST_EFFORT)


@pytest.fixture(scope="module")
def start_peer(
    module_domain_id: int, start_module_program: Callable[..., Program]
) -> Iterator[Callable[..., Peer]]:
    with peers(start_module_program) as start:
        yield start


@pytest.fixture(scope="module")
def peer(start_peer: Callable[..., Peer]) -> Peer:
    return start_peer()


@pytest.fixture(scope="module")
def participant(module_domain_id: int, node: NodeName) -> Iterator[Participant]:
    participant = open_participant(module_domain_id)
    participant.add_node(node)
    yield participant
    participant.close()


@pytest.fixture(scope="module")
def node() -> NodeName:
    return NodeName("/tests", "here")


@pytest.fixture
def topic(request: pytest.FixtureRequest) -> Topic:
    """Return a topic of the test alone."""
    name = re.sub(r"\W", "_", request.node.name)
    return Topic(f"/{name}", "std_msgs/msg/String", "RIHS01_" + "0" * 64)


def padded(data: bytes) -> bytes:
    return data + bytes(-len(data) % 4)


@pytest.mark.parametrize("size", [1, 2, 3, 4, 5, 1000, 65_536, 2_000_001])
def test_payloads_arrive_unchanged(participant, peer, node, topic, take_data, wait_until, size) -> None:
    reader = participant.create_reader(node, topic, KEEP_ALL)
    end, _ = peer("writer", topic, KEEP_ALL)
    wait_until(lambda: peer("matched", end))
    peer("write_random", end, size, size)
    (data,) = take_data(reader, 1)
    assert data == padded(HEADER + random.Random(size).randbytes(size))


def test_many_random_payloads_arrive_in_order(participant, peer, node, topic, take_data, wait_until) -> None:
    end, _ = peer("reader", topic, KEEP_ALL)
    writer = participant.create_writer(node, topic, KEEP_ALL)
    wait_until(writer.matched_count)
    dice = random.Random(1)
    sent = [HEADER + dice.randbytes(dice.randrange(1, 300)) for _ in range(500)]
    for data in sent:
        writer.write(data)
    got: list[str] = []
    wait_until(lambda: got.extend(peer("take", end)) or len(got) >= len(sent))
    assert got == [padded(data).hex() for data in sent]


def test_samples_have_writer_and_stamp(participant, peer, node, topic, wait_until) -> None:
    reader = participant.create_reader(node, topic, KEEP_ALL)
    ends = [peer("writer", topic, KEEP_ALL) for _ in range(2)]
    wait_until(lambda: reader.matched_count() == 2 and all(peer("matched", end) for end, _ in ends))
    samples = []
    for end, _ in ends:
        peer("write_random", end, 0, 8)
        wait_until(lambda: samples.append(reader.take()) or samples[-1] is not None)
    samples = [sample for sample in samples if sample]
    assert [sample.publisher_gid.hex() for sample in samples] == [gid for _, gid in ends]
    for sample in samples:
        assert 0 <= sample.received_stamp_ns - sample.source_stamp_ns < 10_000_000_000


def test_samples_of_an_ended_process_are_complete_and_have_their_writer(
    participant, start_peer, node, topic, wait_until
) -> None:
    reader = participant.create_reader(node, topic, KEEP_ALL)
    peer = start_peer()
    end, gid = peer("writer", topic, QoS())
    wait_until(lambda: peer("matched", end) and reader.matched_count())
    for size in (8, 8, 1_000_000):
        peer("write_random", end, size, size)
    peer("leave")
    wait_until(lambda: reader.matched_count() == 0)
    samples = list(iter(reader.take, None))
    assert [len(sample.data) for sample in samples] == [12, 12, 1_000_004]
    assert {sample.publisher_gid.hex() for sample in samples} == {gid}


@pytest.mark.parametrize("depth", [1, 5])
def test_late_reader_receives_the_samples_of_a_transient_local_writer(
    participant, peer, node, topic, take_data, depth
) -> None:
    end, _ = peer("writer", topic, TRANSIENT_LOCAL._replace(depth=depth))
    for i in range(8):
        peer("write", end, (HEADER + bytes(3) + bytes([i])).hex())
    reader = participant.create_reader(node, topic, TRANSIENT_LOCAL._replace(depth=10))
    last = [data[7] for data in take_data(reader, depth)]
    assert last == list(range(8 - depth, 8))


def test_late_volatile_reader_receives_later_samples_only(
    participant, peer, node, topic, take_data, wait_until
) -> None:
    end, _ = peer("writer", topic, TRANSIENT_LOCAL)
    peer("write", end, (HEADER + b"old.").hex())
    reader = participant.create_reader(node, topic, KEEP_ALL)
    wait_until(lambda: peer("matched", end) and reader.matched_count())
    peer("write", end, (HEADER + b"new.").hex())
    assert take_data(reader, 1) == [HEADER + b"new."]


def test_keep_last_keeps_the_last(participant, peer, node, topic, take_data, wait_until) -> None:
    reader = participant.create_reader(node, topic, QoS(depth=3))
    every = participant.create_reader(node, topic, KEEP_ALL)
    end, _ = peer("writer", topic, KEEP_ALL)
    wait_until(lambda: peer("matched", end) == 2)
    for i in range(20):
        peer("write", end, (HEADER + bytes([i, 0, 0, 0])).hex())
    assert [data[4] for data in take_data(every, 20)] == list(range(20))
    assert [data[4] for data in take_data(reader, 3)] == [17, 18, 19]


def test_best_effort_endpoints_match(participant, peer, node, topic, take_data, wait_until) -> None:
    reader = participant.create_reader(node, topic, BEST_EFFORT)
    end, _ = peer("writer", topic, BEST_EFFORT)
    wait_until(lambda: reader.matched_count() and peer("matched", end))  # either may discover the other first
    peer("write", end, (HEADER + b"data").hex())
    assert take_data(reader, 1) == [HEADER + b"data"]


STRONG = QoS(
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    deadline_ns=1_000_000_000,
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    liveliness_lease_ns=1_000_000_000,
)


@pytest.mark.parametrize(
    "weaker",
    [
        {"reliability": ReliabilityPolicy.BEST_EFFORT},
        {"durability": DurabilityPolicy.VOLATILE},
        {"deadline_ns": 2_000_000_000},
        {"liveliness": LivelinessPolicy.AUTOMATIC},
        {"liveliness_lease_ns": 2_000_000_000},
    ],
    ids=lambda weaker: next(iter(weaker)),
)
def test_weaker_offer_than_requested_does_not_match(
    participant, peer, node, topic, wait_until, weaker
) -> None:
    weak, _ = peer("writer", topic, STRONG._replace(**weaker))
    reader = participant.create_reader(node, topic, STRONG)
    # Endpoints are announced in the order of their creation, so after the second has matched, the first can't match.
    strong, _ = peer("writer", topic, STRONG)
    wait_until(lambda: reader.matched_count() and peer("matched", strong))
    assert reader.matched_count() == 1
    assert peer("matched", weak) == 0


def test_expired_sample_is_not_delivered(participant, peer, node, topic, take_data) -> None:
    brief, _ = peer("writer", topic, TRANSIENT_LOCAL._replace(lifespan_ns=1_000_000))
    lasting, _ = peer("writer", topic, TRANSIENT_LOCAL)
    peer("write", brief, (HEADER + b"brief...").hex())
    peer("cpu_s", 0.05)
    peer("write", lasting, (HEADER + b"lasting.").hex())
    reader = participant.create_reader(node, topic, TRANSIENT_LOCAL)
    assert take_data(reader, 1) == [HEADER + b"lasting."]


def test_sink_receives_all_samples_and_take_none(participant, peer, node, topic, wait_until) -> None:
    queue, sink = ReadyQueue(), SampleQueue(1000)
    reader = participant.create_reader(node, topic, KEEP_ALL)
    reader.notify(queue, 1)
    end, gid = peer("writer", topic, KEEP_ALL)
    wait_until(lambda: peer("matched", end) and reader.matched_count())
    peer("write", end, (HEADER + b"\0\0\0\0").hex())
    wait_until(lambda: queue.wait(0), what="the first sample, before it is fed")
    reader.feed(sink)
    for i in range(1, 100):
        peer("write", end, (HEADER + bytes([i, 0, 0, 0])).hex())
    wait_until(lambda: sink.pushed() == 100)
    samples = sink.take()
    assert [sample[0][4] for sample in samples] == list(range(100))
    assert {sample[3].hex() for sample in samples} == {gid}
    assert reader.take() is None
    assert queue.wait(0) == []


def test_no_sample_is_pushed_after_close(participant, node, topic, wait_until) -> None:
    writer = participant.create_writer(node, topic, QoS())
    for _ in range(20):
        reader = participant.create_reader(node, topic, QoS())
        sink = SampleQueue(1)
        reader.feed(sink)
        wait_until(lambda s=sink: writer.write(HEADER + b"data") or s.pushed())
        reader.close()
        pushed = sink.pushed()
        for _ in range(100):
            writer.write(HEADER + b"data")
        assert sink.pushed() == pushed


def test_notify_posts_at_once_only_if_samples_are_waiting(participant, peer, node, topic, wait_until) -> None:
    first, second = ReadyQueue(), ReadyQueue()
    reader = participant.create_reader(node, topic, KEEP_ALL)
    reader.notify(first, 1)
    assert first.wait(0) == []
    end, _ = peer("writer", topic, KEEP_ALL)
    wait_until(lambda: peer("matched", end) and reader.matched_count())
    for text in (b"one.", b"two."):
        peer("write", end, (HEADER + text).hex())
    wait_until(lambda: first.wait(0), what="the first sample")
    assert reader.take().data == HEADER + b"one."
    reader.notify(second, 2)  # as when a node moves from one executor to another
    assert second.wait(10_000_000_000) == [2]
    wait_until(lambda: (sample := reader.take()) is not None and sample.data == HEADER + b"two.")

    def is_told_of_nothing() -> bool:
        assert reader.take() is None
        reader.notify(first, 3)
        return first.wait(0) == []

    wait_until(is_told_of_nothing)  # the token of a sample may be posted after it has been taken


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"", "not 0 in all"),
        (HEADER, "not 4 in all"),
        (b"\0\0\0\0data", "starts with 00 01"),
        (b"\0\7\0\0data", "starts with 00 01"),
    ],
)
def test_bytes_that_are_not_little_endian_cdr_are_rejected(participant, node, topic, data, text) -> None:
    with pytest.raises(ValueError, match=text):
        participant.create_writer(node, topic, QoS()).write(data)


def test_participant_that_announces_itself_at_a_period_of_its_own(domain_id, start_program) -> None:
    code = "from tfloom.rmw.cyclone.wire import open_participant as o; o(%d, announce_s=0.5).close(); print('open')"
    program = start_program("python", "-c", code % domain_id)
    assert program.wait() == 0, program.output
    assert program.output == "open"


@pytest.mark.parametrize(
    ("data", "is_decoded"),
    [
        (cdr.encode(UInt8MultiArray(data=bytes(range(250)) * 800)), True),
        (cdr.encode(UInt8MultiArray(data=b"small")), False),
        (b"\0\1\0\0" + b"\xff" * 200_000, False),  # of another type, or hostile
        (cdr.encode(UInt8MultiArray(data=bytes(200_000))) + bytes(100), False),  # more than a message
    ],
    ids=["large", "small", "hostile", "too long"],
)
def test_large_samples_are_decoded_in_place(
    participant, node, topic, wait_until, data: bytes, is_decoded: bool
) -> None:
    reader, writer = (
        participant.create_reader(node, topic, QoS()),
        participant.create_writer(node, topic, QoS()),
    )
    wait_until(lambda: writer.matched_count() == 1)
    writer.write(data)
    writer.write(data)
    taken: list[Sample] = []

    def both_have_come() -> bool:
        taken.extend(iter(lambda: reader.take_decoded(UInt8MultiArray), None))
        return len(taken) == 2

    wait_until(both_have_come)
    reader.close()  # the messages hold what was received
    writer.close()
    expected = cdr.decode(UInt8MultiArray, data) if is_decoded else padded(data)
    assert [sample.data for sample in taken] == [expected, expected]
    assert [sample.publisher_gid for sample in taken] == [writer.gid, writer.gid]


def test_sample_waits_if_the_class_is_none_of_a_message(participant, node, topic, wait_until) -> None:
    reader, writer = (
        participant.create_reader(node, topic, QoS()),
        participant.create_writer(node, topic, QoS()),
    )
    wait_until(lambda: writer.matched_count() == 1)
    writer.write(b"\0\1\0\0data")
    with pytest.raises(TypeError):
        reader.take_decoded(int)
    wait_until(lambda: reader.take() is not None)
