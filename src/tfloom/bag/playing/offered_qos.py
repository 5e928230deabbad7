"""The quality of service with which a recorded topic is published again."""

from __future__ import annotations

from tfloom.bag.qos_profiles import parse_profiles
from tfloom.bag.values import Topic
from tfloom.rmw.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoS, ReliabilityPolicy

__all__ = ["MAX_KEPT_MESSAGES", "offered", "offers_differ"]

MAX_KEPT_MESSAGES = 1000
"""How many static transforms' messages are kept for late subscriptions, at most."""
DEPTH_MAX = (1 << 31) - 1
"""The greatest depth that a wire takes."""
_STATIC_TF = "tf_static"


def offers_differ(topic: Topic) -> bool:
    """Return whether the recorded publishers offered different qualities."""
    return (
        len({(profile.reliability, profile.durability) for profile in parse_profiles(topic.offered_qos)}) > 1
    )


def offered(topic: Topic) -> QoS:
    """Return the strongest of the recorded publishers' qualities; the default where the bag has none.

    One publisher takes the place of all recorded ones, so it keeps as many messages as all of them did. That of
    /tf_static keeps all, because each one may be of another frame.
    """
    profiles = parse_profiles(topic.offered_qos)
    is_static = topic.name.rpartition("/")[2] == _STATIC_TF
    if not profiles:
        profiles = [QoS(durability=DurabilityPolicy.TRANSIENT_LOCAL)] if is_static else [QoS()]
    depth = min(sum(max(profile.depth, 1) for profile in profiles), DEPTH_MAX)
    if is_static:
        depth = max(depth, min(topic.message_count, MAX_KEPT_MESSAGES))
    is_reliable = any(profile.reliability == ReliabilityPolicy.RELIABLE for profile in profiles)
    is_kept = any(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in profiles)
    return QoS(
        reliability=ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if is_kept else DurabilityPolicy.VOLATILE,
        history=HistoryPolicy.KEEP_LAST,
        depth=depth,
        # Deadlines are not offered, because a pause would miss them.
        lifespan_ns=max(profile.lifespan_ns for profile in profiles),
        liveliness=LivelinessPolicy.AUTOMATIC,
    ).resolved()
