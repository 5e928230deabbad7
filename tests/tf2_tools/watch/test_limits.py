"""The observer's limits: it counts what is beyond them, and publishers that have left make room."""

from __future__ import annotations

import random

from tests.tf2_tools.recordings import recorded, transform

from tfloom._native import TfObserver

MAX_PUBLISHERS = 4096
MAX_EDGES = 65536
MAX_NAME_SIZE = 1024


def message(children: list[str], parent: str = "base") -> bytes:
    """Return a message with a transform for each child."""
    return recorded(0, *(transform(parent, child, 0) for child in children))[2]


def gid(number: int) -> bytes:
    """Return the gid of a publisher."""
    return number.to_bytes(16, "big")


def test_edges_have_a_limit_and_known_ones_are_counted_beyond_it() -> None:
    observer = TfObserver()
    for first in range(0, MAX_EDGES + 1000, 1000):
        observer.record(message([f"frame_{number}" for number in range(first, first + 1000)]), gid(1), 1)
    observer.record(message(["frame_0", "another"]), gid(1), 2)
    snapshot = observer.snapshot()
    assert len(snapshot.edges) == MAX_EDGES
    assert [edge.statistics.count for edge in snapshot.edges[:2]] == [2, 1]
    assert len(snapshot.edges) + 1 + snapshot.unrecorded == snapshot.publishers[0].transforms


def test_publishers_that_have_left_make_room() -> None:
    observer = TfObserver()
    sink = observer.sink(False)
    data = message(["laser"])
    for number in range(MAX_PUBLISHERS):
        sink.push(data, 0, 1, gid(number))
    sink.push(data, 0, 1, gid(MAX_PUBLISHERS))
    assert observer.snapshot().unrecorded == 1
    for number in range(10, 20):
        sink.forget(gid(number))
    sink.push(data, 0, 1, gid(MAX_PUBLISHERS))
    snapshot = observer.snapshot()
    left = {gid(number) for number in range(MAX_PUBLISHERS + 1)} - {gid(number) for number in range(10, 20)}
    assert (
        {publisher.gid for publisher in snapshot.publishers} == {edge.gid for edge in snapshot.edges} == left
    )
    assert [edge.statistics.count for edge in snapshot.edges if edge.gid == gid(MAX_PUBLISHERS)] == [1]


def test_long_names_are_not_recorded() -> None:
    observer = TfObserver()
    assert observer.record(message(["x" * MAX_NAME_SIZE, "x" * (MAX_NAME_SIZE + 1)]), gid(1), 1)
    snapshot = observer.snapshot()
    assert ([len(edge.child) for edge in snapshot.edges], snapshot.unrecorded) == ([MAX_NAME_SIZE], 1)


def test_spoilt_messages_are_counted_and_nothing_else() -> None:
    observer = TfObserver()
    sound, numbers = message(["a", "b"]), random.Random(1)
    unreadable = 0
    for _ in range(2000):
        spoilt = bytearray(sound)
        for _ in range(3):
            spoilt[numbers.randrange(len(spoilt))] = numbers.randrange(256)
        data = bytes(spoilt[: numbers.randrange(len(spoilt) + 1)])
        unreadable += not observer.record(data, gid(1), 2**63 - 1)
    (traffic,) = observer.snapshot().publishers
    assert (traffic.messages, traffic.unreadable) == (2000, unreadable)
    assert unreadable > 0
    observer.clear()
    assert observer.snapshot().publishers == []
