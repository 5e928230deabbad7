"""Reading a recording, or a file of static transforms."""

from __future__ import annotations

import struct
from collections import Counter
from pathlib import Path

from tfloom._native import HeaderSink
from tfloom.bag.opening import open_bag
from tfloom.bag.values import Topic
from tfloom.tf2_tools.diagnosis.finding import Source
from tfloom.tf2_tools.diagnosis.subject import FrameUse, Subject, begins_with_header
from tfloom.tf2_tools.watch.model import TOPICS
from tfloom.tf2_tools.watch.sources import is_static_file, open_path

ROS1 = "ros1"
"""The format of messages in bags of ROS 1."""
_ROS1_HEADER = struct.Struct("<IIII")
"""seq, stamp.secs, stamp.nsecs, and the length of frame_id."""
_NO_GID = bytes(16)


def read(path: Path, *, with_topics: bool = False, topics: tuple[str, str] = TOPICS) -> Subject:
    """Return what a bag or a file of static transforms holds. Recordings name no publishers.

    Args:
        path: A file that ends in .yaml or .yml, or a bag.
        with_topics: Whether to read the headers of all topics of a bag as well.
        topics: The topics of moving and of static transforms.

    Raises:
        StaticFileError: it is not a file of static transforms.
        BagError: it is not a bag, or has no transforms.
        OSError: it can't be read.
    """
    observation = open_path(path, topics=topics).observation()
    uses = _header_uses(path) if with_topics and not is_static_file(path) else []
    return Subject(
        observation, (observation.started_ns, observation.taken_ns), uses, static_topic=topics[True]
    )


def _header_uses(path: Path) -> list[FrameUse]:
    with open_bag(path) as bag:
        headed = {name: topic for name, topic in bag.topics.items() if begins_with_header(_ros2_name(topic))}
        sinks = {name: HeaderSink() for name in headed}
        of_ros1: Counter[tuple[str, str]] = Counter()
        for message in bag.messages(list(headed)) if headed else ():
            # The native sink reads CDR. A message of ROS 1 has another layout, and its frame is read here.
            if headed[message.topic].serialization_format == ROS1:
                of_ros1[message.topic, ros1_frame_id(message.data)] += 1
            else:
                sinks[message.topic].push(message.data, 0, message.log_time_ns, _NO_GID)
    uses = [
        FrameUse(frame, Source("", name), count)
        for name, sink in sinks.items()
        for _, frame, count in sink.uses()
    ]
    return uses + [FrameUse(frame, Source("", name), count) for (name, frame), count in of_ros1.items()]


def _ros2_name(topic: Topic) -> str:
    """Return the name of a topic's type in ROS 2's form; that of ROS 1 has no `msg`."""
    package, _, name = topic.type.rpartition("/")
    return topic.type if package.endswith("/msg") else f"{package}/msg/{name}"


def ros1_frame_id(data: bytes) -> str:
    """Return the frame in the header at the start of a message of ROS 1; empty if there is none."""
    if len(data) < _ROS1_HEADER.size:
        return ""
    length = _ROS1_HEADER.unpack_from(data)[3]
    if length > len(data) - _ROS1_HEADER.size:
        return ""
    return data[_ROS1_HEADER.size :][:length].decode("utf-8", "replace")
