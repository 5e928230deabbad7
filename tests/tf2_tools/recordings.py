"""Messages of /tf as recordings hold them, for observations without a wire."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from contextlib import closing
from pathlib import Path

from tfloom.bag.values import Topic
from tfloom.bag.writing.bag_writer import BagWriter
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr
from tfloom.tf2_tools.watch.recorded import RecordedMessage

START_NS = 1_700_000_000_000_000_000
MS = 1_000_000


def transform(
    parent: str,
    child: str,
    stamp_ns: int,
    translation: Sequence[float] = (0.0, 0.0, 0.0),
    yaw_rad: float = 0.0,
    rotation_xyzw: Sequence[float] | None = None,
) -> TransformStamped:
    """Return a stamped transform, turned about z or by a quaternion."""
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
    moved, turned = message.transform.translation, message.transform.rotation
    moved.x, moved.y, moved.z = translation
    about_z = (0.0, 0.0, math.sin(yaw_rad / 2), math.cos(yaw_rad / 2))
    turned.x, turned.y, turned.z, turned.w = about_z if rotation_xyzw is None else rotation_xyzw
    return message


def recorded(received_ns: int, *transforms: TransformStamped, topic: str = "/tf") -> RecordedMessage:
    """Return a message as a recording holds it."""
    return topic, received_ns, cdr.encode(TFMessage(transforms=list(transforms)))


def write_bag(folder: Path, messages: Iterable[RecordedMessage]) -> Path:
    """Write a recording of these messages, and return its folder."""
    with closing(BagWriter(folder)) as writer:
        channels = {
            name: writer.add_topic(Topic(name, "tf2_msgs/msg/TFMessage")) for name in ("/tf", "/tf_static")
        }
        for topic, received_ns, data in messages:
            writer.push(channels[topic], data, received_ns, received_ns)
    return folder
