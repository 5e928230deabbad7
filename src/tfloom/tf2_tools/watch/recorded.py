"""Observation of recorded messages: of a bag, or made by a test."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable

from tfloom._native import TfObserver
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.watch.model import TOPICS, Description, Observation, observation_of

__all__ = ["RecordedMessage", "observe_recorded"]

RecordedMessage = tuple[str, int, bytes]
"""Topic, time of receipt [ns since epoch], and the message: encapsulation header and CDR."""


def observe_recorded(
    messages: Iterable[RecordedMessage],
    origin: str,
    *,
    buffer: Buffer | None = None,
    topics: tuple[str, str] = TOPICS,
    ros1: bool = False,
    cache_time_ns: int = 10_000_000_000,
) -> Observation:
    """Return what recorded messages hold. Each topic counts as one publisher, because recordings name none.

    Args:
        messages: The messages, in order of receipt; those of other topics are left out.
        origin: The name of the recording, for texts.
        buffer: A buffer to fill as well.
        topics: The topics of moving and of static transforms.
        ros1: Whether the messages are serialized as by ROS 1.
        cache_time_ns: Age beyond a frame's newest stamp above which a transform counts as too old [ns].
    """
    observer = TfObserver(cache_time_ns)
    gids = {topic: hashlib.sha256(f"{origin}\0{topic}".encode()).digest()[:16] for topic in topics}
    first_ns = last_ns = 0
    for topic, received_ns, data in messages:
        # A gid of each topic stands for all of its publishers: it is a digest, so that two recordings differ.
        if topic not in gids:
            continue
        observer.record(data, gids[topic], received_ns, topic == topics[True], ros1, buffer)
        first_ns = first_ns or received_ns
        last_ns = received_ns
    described = dict.fromkeys(gids.values(), Description(origin=origin))
    return observation_of(observer.snapshot(), described, (first_ns, last_ns), topics=topics)
