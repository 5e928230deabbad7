"""Quality of service as a wire knows it: plain numbers, in nanoseconds. Programs use `node/qos/qos.py`."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

INFINITE_NS = 0x7FFF_FFFF_FFFF_FFFF
"""A duration [ns] that never ends: no deadline, no lifespan, no lease."""

BEST_AVAILABLE_NS = INFINITE_NS - 1
"""The duration [ns] by which ROS says "whatever meets the others on the topic"."""


class ReliabilityPolicy(IntEnum):
    """Whether a writer sends again what a reader missed."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(IntEnum):
    """Whether a reader that comes late is sent what was written before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class HistoryPolicy(IntEnum):
    """Whether an end keeps all samples or the last `depth`."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class LivelinessPolicy(IntEnum):
    """Who says that a writer is alive: the wire, or each write."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


class QoS(NamedTuple):
    """What a writer offers or a reader asks for. Durations in nanoseconds, `INFINITE_NS` for none."""

    reliability: ReliabilityPolicy = ReliabilityPolicy.RELIABLE
    durability: DurabilityPolicy = DurabilityPolicy.VOLATILE
    history: HistoryPolicy = HistoryPolicy.KEEP_LAST
    depth: int = 10
    deadline_ns: int = INFINITE_NS
    lifespan_ns: int = INFINITE_NS
    liveliness: LivelinessPolicy = LivelinessPolicy.AUTOMATIC
    liveliness_lease_ns: int = INFINITE_NS

    def resolved(self) -> QoS:
        """Return this with each system default replaced by ROS's: reliable, volatile, keep the last, automatic.

        A depth of 0 becomes 1, a duration of 0 becomes `INFINITE_NS`, as in ROS.
        """
        return QoS(
            reliability=self.reliability or ReliabilityPolicy.RELIABLE,
            durability=self.durability or DurabilityPolicy.VOLATILE,
            history=self.history or HistoryPolicy.KEEP_LAST,
            depth=max(self.depth, 1),
            deadline_ns=_limited(self.deadline_ns),
            lifespan_ns=_limited(self.lifespan_ns),
            liveliness=self.liveliness or LivelinessPolicy.AUTOMATIC,
            liveliness_lease_ns=_limited(self.liveliness_lease_ns),
        )


def _limited(duration_ns: int) -> int:
    return duration_ns if 0 < duration_ns < INFINITE_NS else INFINITE_NS
