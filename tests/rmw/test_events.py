"""Events: matches, incompatibilities, missed deadlines, lost liveliness."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom._native import ReadyQueue
from tfloom.rmw.base import NodeName, Participant
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.errors import ClosedError, UnsupportedEventError
from tfloom.rmw.events import Count, Event, IncompatibleQoS, LivelinessChanged, Matched
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    QoSPolicyKind,
    ReliabilityPolicy,
)

NODE = NodeName("/", "n")
DATA = b"\0\1\0\0data"
MS = 1_000_000


@pytest.fixture(params=["local", pytest.param("cyclonedds", marks=pytest.mark.wire)])
def wire(request: pytest.FixtureRequest, domain_id: int) -> Iterator[Participant]:
    module = {"local": local, "cyclonedds": cyclonedds}[request.param]
    participant = module.open_participant(domain_id)
    yield participant
    participant.close()


@pytest.fixture
def take_event(wait_until: Callable[..., None]) -> Callable[[Any, Event], Any]:
    """Wait for a change of an event's status, and take it."""

    def take(end: Any, event: Event) -> Any:
        taken: list[Any] = []
        wait_until(lambda: taken.append(end.take_event(event)) or taken[-1] is not None, what=event.name)
        return taken[-1]

    return take


def test_matches_are_counted_on_both_sides(wire, topic, take_event) -> None:
    writer = wire.create_writer(NODE, topic, QoS())
    assert writer.take_event(Event.MATCHED) is None
    reader = wire.create_reader(NODE, topic, QoS())
    assert take_event(writer, Event.MATCHED) == Matched(1, 1, 1, 1)
    assert take_event(reader, Event.MATCHED) == Matched(1, 1, 1, 1)
    assert writer.take_event(Event.MATCHED) is None
    reader.close()
    assert take_event(writer, Event.MATCHED) == Matched(1, 0, 0, -1)
    wire.create_reader(NODE, topic, QoS())
    assert take_event(writer, Event.MATCHED) == Matched(2, 1, 1, 1)


@pytest.mark.parametrize(
    ("offered", "kind"),
    [
        ({"reliability": ReliabilityPolicy.BEST_EFFORT}, QoSPolicyKind.RELIABILITY),
        ({"durability": DurabilityPolicy.VOLATILE}, QoSPolicyKind.DURABILITY),
        ({"deadline_ns": 2_000 * MS}, QoSPolicyKind.DEADLINE),
        ({"liveliness": LivelinessPolicy.AUTOMATIC}, QoSPolicyKind.LIVELINESS),
    ],
)
def test_incompatibility_names_its_policy_on_both_sides(wire, topic, take_event, offered, kind) -> None:
    asked = QoS(
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        deadline_ns=1_000 * MS,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    )
    writer = wire.create_writer(NODE, topic, asked._replace(**offered))
    reader = wire.create_reader(NODE, topic, asked)
    for end in (writer, reader):
        assert take_event(end, Event.INCOMPATIBLE_QOS) == IncompatibleQoS(1, 1, kind)
        assert end.take_event(Event.INCOMPATIBLE_QOS) is None
        assert end.take_event(Event.MATCHED) is None


def test_tokens_are_posted_at_the_start_and_on_changes(wire, topic, wait_until) -> None:
    queue = ReadyQueue()
    writer = wire.create_writer(NODE, topic, QoS())
    writer.notify_event(Event.MATCHED, queue, 4)
    assert queue.wait(0) == [4]
    reader = wire.create_reader(NODE, topic, QoS())
    assert queue.wait(5_000 * MS) == [4]
    wait_until(lambda: writer.take_event(Event.MATCHED) and not queue.wait(0))
    writer.notify_event(Event.MATCHED, None)
    reader.close()
    wait_until(lambda: writer.take_event(Event.MATCHED))
    assert queue.wait(0) == []


def test_each_kind_of_endpoint_has_its_events(participant, node, topic) -> None:
    writer = participant.create_writer(node, topic, QoS())
    reader = participant.create_reader(node, topic, QoS())
    for end, missing, text in (
        (writer, (Event.LIVELINESS_CHANGED, Event.MESSAGE_LOST), "writers have no such event"),
        (reader, (Event.LIVELINESS_LOST,), "readers have no such event"),
    ):
        for event in Event:
            if event not in missing:
                end.take_event(event)
                continue
            with pytest.raises(UnsupportedEventError, match=f"{event.name}: {text}"):
                end.take_event(event)
            with pytest.raises(UnsupportedEventError):
                end.notify_event(event, ReadyQueue(), 1)


def test_local_wire_names_its_events_in_the_error(topic) -> None:
    participant = local.open_participant(1)
    writer = participant.create_writer(NODE, topic, QoS())
    with pytest.raises(
        UnsupportedEventError, match="the in-process wire has MATCHED and INCOMPATIBLE_QOS alone"
    ):
        writer.notify_event(Event.DEADLINE_MISSED, ReadyQueue(), 1)
    participant.close()


def test_missed_deadlines_are_counted_on_both_sides(participant, node, topic, take_event) -> None:
    queue = ReadyQueue()
    qos = QoS(deadline_ns=20 * MS)
    writer = participant.create_writer(node, topic, qos)
    reader = participant.create_reader(node, topic, qos)
    reader.notify_event(Event.DEADLINE_MISSED, queue, 8)
    take_event(reader, Event.MATCHED)
    queue.wait(0)
    writer.write(DATA)
    assert queue.wait(5_000 * MS) == [8]
    for end in (writer, reader):
        first = take_event(end, Event.DEADLINE_MISSED)
        assert isinstance(first, Count)
        assert first.total_count == first.total_count_change >= 1
        second = take_event(end, Event.DEADLINE_MISSED)
        assert second.total_count == first.total_count + second.total_count_change


def test_writer_without_assertions_loses_its_liveliness(
    participant, start_peer, node, topic, take_event
) -> None:
    qos = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=200 * MS)
    reader = participant.create_reader(node, topic, qos)
    peer = start_peer()
    end, _ = peer("writer", topic, qos)
    take_event(reader, Event.MATCHED)

    def wait_for_counts(alive: int, not_alive: int) -> None:
        while True:
            status = take_event(reader, Event.LIVELINESS_CHANGED)
            if (status.alive_count, status.not_alive_count) == (alive, not_alive):
                return

    for _ in range(2):
        peer("write", end, DATA.hex())
        wait_for_counts(1, 0)
        wait_for_counts(0, 1)


def test_asserting_writer_stays_alive(participant, start_peer, node, topic, take_event) -> None:
    qos = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=600 * MS)
    reader = participant.create_reader(node, topic, qos)
    peer = start_peer()
    end, _ = peer("writer", topic, qos)
    peer("write", end, DATA.hex())
    assert take_event(reader, Event.LIVELINESS_CHANGED) == LivelinessChanged(1, 0, 1, 0)
    peer("assert_liveliness", end, 1.0, 0.05)
    assert reader.take_event(Event.LIVELINESS_CHANGED) is None
    assert take_event(reader, Event.LIVELINESS_CHANGED) == LivelinessChanged(0, 1, -1, 1)


def test_lost_liveliness_is_reported_to_the_writer(participant, node, topic, take_event) -> None:
    qos = QoS(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_ns=20 * MS)
    writer = participant.create_writer(node, topic, qos)
    writer.assert_liveliness()
    assert take_event(writer, Event.LIVELINESS_LOST) == Count(1, 1)


def test_killed_writer_is_not_alive_after_its_lease(participant, start_peer, node, topic, take_event) -> None:
    qos = QoS(liveliness_lease_ns=200 * MS)
    reader = participant.create_reader(node, topic, qos)
    peer = start_peer()
    peer("writer", topic, qos)
    assert take_event(reader, Event.LIVELINESS_CHANGED) == LivelinessChanged(1, 0, 1, 0)
    os.kill(peer.pid, signal.SIGKILL)
    assert take_event(reader, Event.LIVELINESS_CHANGED) == LivelinessChanged(0, 1, -1, 1)


def test_wait_for_acks_returns_when_all_have_acknowledged(
    participant, start_peer, node, topic, wait_until
) -> None:
    writer = participant.create_writer(node, topic, QoS(history=HistoryPolicy.KEEP_ALL))
    assert writer.wait_for_acks(0)
    peer = start_peer()
    end, _ = peer("reader", topic, QoS(history=HistoryPolicy.KEEP_ALL))
    wait_until(writer.matched_count)
    for _ in range(100):
        writer.write(DATA)
    assert writer.wait_for_acks(5_000 * MS)
    assert len(peer("take", end)) == 100
    peer.program.pause()
    writer.write(DATA)
    assert not writer.wait_for_acks(0)
    assert not writer.wait_for_acks(150 * MS)
    os.kill(peer.pid, signal.SIGCONT)
    assert writer.wait_for_acks(-1)
    writer.close()
    with pytest.raises(ClosedError):
        writer.wait_for_acks(0)


@pytest.mark.parametrize("strong", [True, False])
def test_best_available_readers_match_the_present_writers(wire, topic, wait_until, strong: bool) -> None:
    best = QoS(
        ReliabilityPolicy.BEST_AVAILABLE,
        DurabilityPolicy.BEST_AVAILABLE,
        liveliness=LivelinessPolicy.BEST_AVAILABLE,
    )
    offered = QoS(
        ReliabilityPolicy.RELIABLE if strong else ReliabilityPolicy.BEST_EFFORT,
        DurabilityPolicy.TRANSIENT_LOCAL if strong else DurabilityPolicy.VOLATILE,
    )
    wire.create_writer(NODE, topic, offered)
    reader = wire.create_reader(NODE, topic, best)
    wait_until(reader.matched_count)
    (qos,) = (end.qos for end in wire.graph.endpoints() if not end.is_writer)
    assert (qos.reliability, qos.durability, qos.liveliness) == (*offered[:2], LivelinessPolicy.AUTOMATIC)
