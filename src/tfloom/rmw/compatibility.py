"""Which readers and writers connect: what is asked for must not exceed what is offered (DDS 1.4, 2.2.3)."""

from __future__ import annotations

from enum import IntEnum

from tfloom.rmw.qos import QoS


class PolicyKind(IntEnum):
    """The policies that can keep two ends apart, by ROS's numbers."""

    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16


def incompatible_policies(offered: QoS, requested: QoS) -> list[PolicyKind]:
    """Return the policies by which a writer that offers and a reader that asks don't connect; empty if they do.

    Both are resolved ones (`QoS.resolved`).
    """
    apart = {
        # ROS numbers the stronger of each two lower.
        PolicyKind.DURABILITY: offered.durability > requested.durability,
        PolicyKind.DEADLINE: offered.deadline_ns > requested.deadline_ns,
        PolicyKind.LIVELINESS: offered.liveliness < requested.liveliness
        or offered.liveliness_lease_ns > requested.liveliness_lease_ns,
        PolicyKind.RELIABILITY: offered.reliability > requested.reliability,
    }
    return [kind for kind, is_apart in apart.items() if is_apart]
