"""The quality of service with which a recorder subscribes, so that it receives from every publisher of a topic."""

from __future__ import annotations

from collections.abc import Sequence

from tfloom.rmw.compatibility import incompatible_policies
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, QoS, QoSPolicyKind, ReliabilityPolicy

__all__ = ["adapted", "unmet_policies", "warnings_of"]


def adapted(offers: Sequence[QoS]) -> QoS:
    """Return the strongest profile that is compatible with all offers; the default without any.

    All samples are kept until they are taken, so that none is replaced by a later one.
    """
    reliable = all(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers)
    kept = offers and all(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
    return QoS(
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE,
        history=HistoryPolicy.KEEP_ALL,
    )


def warnings_of(topic: str, offers: Sequence[QoS]) -> list[str]:
    """Return what the user should know about a profile that is adapted to different offers."""
    texts = []
    if 0 < sum(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers) < len(offers):
        texts.append(
            f"Some, but not all, publishers on topic '{topic}' are reliable. It is recorded as best effort, which "
            "receives from all of them: messages from reliable publishers may be lost."
        )
    if 0 < sum(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers) < len(offers):
        texts.append(
            f"Some, but not all, publishers on topic '{topic}' are transient local. It is recorded as volatile, which "
            "receives from all of them: messages that were published before are not recorded."
        )
    return texts


def unmet_policies(offer: QoS, requested: QoS) -> list[QoSPolicyKind]:
    """Return the policies for which nothing is received from a publisher."""
    return incompatible_policies(offer.resolved(), requested.resolved())
