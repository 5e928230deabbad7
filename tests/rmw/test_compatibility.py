"""The rules of compatibility between offered and requested qualities of service."""

from __future__ import annotations

from itertools import product
from types import SimpleNamespace
from typing import Any

import pytest

from tfloom.rmw.base import EndpointInfo, NodeName, Topic
from tfloom.rmw.compatibility import (
    QoSPolicyKind,
    best_available,
    incompatible_policies,
    is_best_available,
)
from tfloom.rmw.events import IncompatibleQoS
from tfloom.rmw.qos import (
    BEST_AVAILABLE_NS,
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)
from tfloom.rmw.shared.qos_mismatch import MAX_DIFFERENCES, mismatch_text

STRONG = QoS(
    ReliabilityPolicy.RELIABLE,
    DurabilityPolicy.TRANSIENT_LOCAL,
    deadline_ns=10,
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    liveliness_lease_ns=10,
)
WEAK = QoS(ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE)
FIELDS = {
    QoSPolicyKind.RELIABILITY: ["reliability"],
    QoSPolicyKind.DURABILITY: ["durability"],
    QoSPolicyKind.DEADLINE: ["deadline_ns"],
    QoSPolicyKind.LIVELINESS: ["liveliness", "liveliness_lease_ns"],
}


def test_equal_and_stronger_offers_are_compatible() -> None:
    for offered, requested in [(STRONG, STRONG), (WEAK, WEAK), (STRONG, WEAK)]:
        assert incompatible_policies(offered, requested) == []


@pytest.mark.parametrize(("kind", "field"), [(k, f) for k, fields in FIELDS.items() for f in fields])
def test_one_weaker_offer_is_incompatible(kind: QoSPolicyKind, field: str) -> None:
    offered = STRONG._replace(**{field: getattr(WEAK, field)})
    assert incompatible_policies(offered, STRONG) == [kind]
    assert incompatible_policies(STRONG, offered) == []


def test_all_incompatible_policies_are_named() -> None:
    assert incompatible_policies(WEAK, STRONG) == [
        QoSPolicyKind.DURABILITY,
        QoSPolicyKind.DEADLINE,
        QoSPolicyKind.LIVELINESS,
        QoSPolicyKind.RELIABILITY,
    ]


def test_history_depth_and_lifespan_are_always_compatible() -> None:
    for history, depth, lifespan_ns in product(HistoryPolicy, (0, 1, 100), (0, 1, INFINITE_NS)):
        other = STRONG._replace(history=history, depth=depth, lifespan_ns=lifespan_ns)
        assert incompatible_policies(STRONG, other) == incompatible_policies(other, STRONG) == []


def test_system_defaults_resolve_to_those_of_ros() -> None:
    unset = QoS(*[type(value)(0) for value in QoS()])
    assert unset.resolved() == QoS(depth=1)
    assert STRONG.resolved() == STRONG


BEST = QoS(
    ReliabilityPolicy.BEST_AVAILABLE,
    DurabilityPolicy.BEST_AVAILABLE,
    deadline_ns=BEST_AVAILABLE_NS,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_ns=BEST_AVAILABLE_NS,
)


@pytest.mark.parametrize("theirs", [[], [STRONG], [WEAK], [STRONG, WEAK], [WEAK, STRONG, STRONG]])
def test_best_available_is_compatible_with_all(theirs: list[QoS]) -> None:
    writer = best_available(BEST, theirs, is_writer=True)
    reader = best_available(BEST, theirs, is_writer=False)
    assert not is_best_available(writer)
    assert not is_best_available(reader)
    for other in theirs:
        assert incompatible_policies(writer, other) == []
        assert incompatible_policies(other, reader) == []


def test_best_available_is_the_strongest_compatible_policy() -> None:
    assert best_available(BEST, [STRONG], is_writer=False) == STRONG._replace(depth=BEST.depth)
    assert best_available(BEST, [STRONG], is_writer=True) == STRONG._replace(depth=BEST.depth)
    alone = best_available(BEST, [], is_writer=True)
    assert alone == QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)


def test_other_policies_are_unchanged() -> None:
    for qos in (STRONG, WEAK):
        assert not is_best_available(qos)
        assert best_available(qos, [WEAK, STRONG], is_writer=False) == qos


BEST_VALUES = {
    "reliability": ReliabilityPolicy.BEST_AVAILABLE,
    "durability": DurabilityPolicy.BEST_AVAILABLE,
    "deadline_ns": BEST_AVAILABLE_NS,
    "liveliness": LivelinessPolicy.BEST_AVAILABLE,
    "liveliness_lease_ns": BEST_AVAILABLE_NS,
}


@pytest.mark.parametrize("field", BEST_VALUES)
def test_best_available_of_rmw_zenoh_is_compatible_with_each_policy(field: str) -> None:
    weak = WEAK._replace(deadline_ns=10, liveliness_lease_ns=10) if field.endswith("_ns") else WEAK
    for other in (STRONG, weak, WEAK._replace(**BEST_VALUES)):
        mine = other._replace(**{field: BEST_VALUES[field]})
        assert incompatible_policies(mine, other) == []
        assert incompatible_policies(other, mine) == []


def endpoint(number: int, name: str, *, is_writer: bool, qos: QoS) -> EndpointInfo:
    topic = Topic("/chatter", "std_msgs/msg/String", "")
    return EndpointInfo(topic, NodeName("/", name), is_writer, bytes([number]) * 16, qos)


def test_warning_shows_names_as_data_and_few_of_many_peers() -> None:
    peers = [
        endpoint(number, f"n{number}\x1b[31m\nall is well", is_writer=True, qos=WEAK)
        for number in range(1, 40)
    ]
    mine = endpoint(0, "mine", is_writer=False, qos=QoS())
    graph: Any = SimpleNamespace(endpoints=lambda: [mine, *peers], delivers_incompatible=lambda: False)
    status = IncompatibleQoS(1, 1, QoSPolicyKind.RELIABILITY)
    text = mismatch_text(status, "/chatter", mine.gid, graph, is_publisher=False)
    assert text.count("peer /n") == MAX_DIFFERENCES
    assert text.endswith(f"; and {39 - MAX_DIFFERENCES} more)")
    assert r"peer /n1\x1b[31m\x0aall is well" in text
    peers[MAX_DIFFERENCES:] = []
    assert "more" not in mismatch_text(status, "/chatter", mine.gid, graph, is_publisher=False)
