"""Compatibility of writers and readers: the requested policies must not exceed the offered ones (DDS 1.4, 2.2.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.rmw.qos import (
    BEST_AVAILABLE_NS,
    INFINITE_NS,
    DurabilityPolicy,
    LivelinessPolicy,
    QoS,
    QoSPolicyKind,
    ReliabilityPolicy,
)

if TYPE_CHECKING:
    from tfloom.rmw.base import Graph


def incompatible_policies(offered: QoS, requested: QoS) -> list[QoSPolicyKind]:
    """Return the policies that prevent a writer and a reader from connecting; empty if they connect.

    BEST_AVAILABLE, as rmw_zenoh announces it, is compatible with each policy.

    Args:
        offered: The writer's quality, resolved (`QoS.resolved`).
        requested: The reader's quality, resolved.
    """

    def exceeds(one: int, other: int, best_available: int) -> bool:
        return one > other and best_available not in {one, other}

    apart = {
        # In ROS's numbering, the stronger policy has the lower number.
        QoSPolicyKind.DURABILITY: exceeds(
            offered.durability, requested.durability, DurabilityPolicy.BEST_AVAILABLE
        ),
        QoSPolicyKind.DEADLINE: exceeds(offered.deadline_ns, requested.deadline_ns, BEST_AVAILABLE_NS),
        QoSPolicyKind.LIVELINESS: exceeds(
            requested.liveliness, offered.liveliness, LivelinessPolicy.BEST_AVAILABLE
        )
        or exceeds(offered.liveliness_lease_ns, requested.liveliness_lease_ns, BEST_AVAILABLE_NS),
        QoSPolicyKind.RELIABILITY: exceeds(
            offered.reliability, requested.reliability, ReliabilityPolicy.BEST_AVAILABLE
        ),
    }
    return [kind for kind, is_apart in apart.items() if is_apart]


def is_best_available(qos: QoS) -> bool:
    """Return whether a policy of `qos` depends on the other endpoints of the topic."""
    return (
        qos.reliability == ReliabilityPolicy.BEST_AVAILABLE
        or qos.durability == DurabilityPolicy.BEST_AVAILABLE
        or qos.liveliness == LivelinessPolicy.BEST_AVAILABLE
        or BEST_AVAILABLE_NS in {qos.deadline_ns, qos.liveliness_lease_ns}
    )


def chosen_qos(qos: QoS, graph: Graph, topic_name: str, *, is_writer: bool) -> QoS:
    """Return the quality of a new writer or reader, with each BEST_AVAILABLE policy chosen by the topic's others."""
    if not is_best_available(qos):
        return qos
    others = [end for end in graph.endpoints() if end.topic.name == topic_name]
    return best_available(qos, [end.qos for end in others if end.is_writer != is_writer], is_writer=is_writer)


def best_available(qos: QoS, theirs: list[QoS], *, is_writer: bool) -> QoS:
    """Return `qos` with each BEST_AVAILABLE policy replaced by the strongest that is compatible with all of `theirs`.

    A writer offers the strongest policy; a reader requests what every writer of the topic offers.

    Args:
        qos: The quality of a new writer or reader.
        theirs: The qualities of the topic's present readers, or writers.
        is_writer: Whether `qos` is a writer's, not a reader's.
    """
    reliability, durability, liveliness = qos.reliability, qos.durability, qos.liveliness
    if reliability == ReliabilityPolicy.BEST_AVAILABLE:
        all_reliable = all(other.reliability == ReliabilityPolicy.RELIABLE for other in theirs)
        strong = is_writer or all_reliable
        reliability = ReliabilityPolicy.RELIABLE if strong else ReliabilityPolicy.BEST_EFFORT
    if durability == DurabilityPolicy.BEST_AVAILABLE:
        all_kept = all(other.durability == DurabilityPolicy.TRANSIENT_LOCAL for other in theirs)
        strong = is_writer or all_kept
        durability = DurabilityPolicy.TRANSIENT_LOCAL if strong else DurabilityPolicy.VOLATILE
    if liveliness == LivelinessPolicy.BEST_AVAILABLE:
        manual = [other.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC for other in theirs]
        strong = any(manual) if is_writer else bool(manual) and all(manual)
        liveliness = LivelinessPolicy.MANUAL_BY_TOPIC if strong else LivelinessPolicy.AUTOMATIC
    return qos._replace(
        reliability=reliability,
        durability=durability,
        liveliness=liveliness,
        deadline_ns=_best_duration(
            qos.deadline_ns, [other.deadline_ns for other in theirs], is_writer=is_writer
        ),
        liveliness_lease_ns=_best_duration(
            qos.liveliness_lease_ns, [other.liveliness_lease_ns for other in theirs], is_writer=is_writer
        ),
    )


def _best_duration(duration_ns: int, theirs_ns: list[int], *, is_writer: bool) -> int:
    """Return the shortest requested duration for a writer, the longest offered one for a reader."""
    if duration_ns != BEST_AVAILABLE_NS:
        return duration_ns
    if not theirs_ns:
        return INFINITE_NS
    return min(theirs_ns) if is_writer else max(theirs_ns)
