"""The rules of compatibility between offered and requested qualities of service."""

from __future__ import annotations

from itertools import product

import pytest

from tfloom.rmw.compatibility import (
    QoSPolicyKind,
    best_available,
    incompatible_policies,
    is_best_available,
)
from tfloom.rmw.qos import (
    BEST_AVAILABLE_NS,
    INFINITE_NS,
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoS,
    ReliabilityPolicy,
)

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
