"""The rules by which offered and requested qualities of service meet."""

from __future__ import annotations

from itertools import product

import pytest

from tfloom.rmw.compatibility import PolicyKind, incompatible_policies
from tfloom.rmw.qos import (
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
    PolicyKind.RELIABILITY: ["reliability"],
    PolicyKind.DURABILITY: ["durability"],
    PolicyKind.DEADLINE: ["deadline_ns"],
    PolicyKind.LIVELINESS: ["liveliness", "liveliness_lease_ns"],
}


def test_equal_ones_and_stronger_offers_meet() -> None:
    for offered, requested in [(STRONG, STRONG), (WEAK, WEAK), (STRONG, WEAK)]:
        assert incompatible_policies(offered, requested) == []


@pytest.mark.parametrize(("kind", "field"), [(k, f) for k, fields in FIELDS.items() for f in fields])
def test_one_weaker_offer_keeps_the_ends_apart(kind: PolicyKind, field: str) -> None:
    offered = STRONG._replace(**{field: getattr(WEAK, field)})
    assert incompatible_policies(offered, STRONG) == [kind]
    assert incompatible_policies(STRONG, offered) == []


def test_all_that_differ_are_named() -> None:
    assert incompatible_policies(WEAK, STRONG) == list(PolicyKind)


def test_history_depth_and_lifespan_do_not_matter() -> None:
    for history, depth, lifespan_ns in product(HistoryPolicy, (0, 1, 100), (0, 1, INFINITE_NS)):
        other = STRONG._replace(history=history, depth=depth, lifespan_ns=lifespan_ns)
        assert incompatible_policies(STRONG, other) == incompatible_policies(other, STRONG) == []


def test_system_defaults_resolve_to_those_of_ros() -> None:
    unset = QoS(*[type(value)(0) for value in QoS()])
    assert unset.resolved() == QoS(depth=1)
    assert STRONG.resolved() == STRONG
