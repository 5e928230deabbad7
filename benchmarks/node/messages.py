"""The messages of the measurements, with ROS's names alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from std_msgs.msg import Header, UInt8MultiArray
from tf2_msgs.msg import TFMessage

from benchmarks.node.ros_trips import SIZES


def tf_message(transforms: int) -> TFMessage:
    """Return a message in which most numbers are neither 0 nor 1, as in a robot's messages."""
    return TFMessage(
        transforms=[
            TransformStamped(
                header=Header(frame_id="base"),
                child_frame_id=f"joint_{i}",
                transform=Transform(
                    translation=Vector3(x=1.5, y=-0.25, z=0.125), rotation=Quaternion(z=0.6, w=0.8)
                ),
            )
            for i in range(transforms)
        ]
    )


def octets(size: int) -> UInt8MultiArray:
    return UInt8MultiArray(data=bytes(range(256)) * (size // 256))


class Numbered(NamedTuple):
    """A kind of message that carries a number."""

    type: type
    message: Callable[[int], Any]
    """Returns the message with a number."""
    number: Callable[[Any], int]
    """Returns the number in a message."""


NUMBER_AT = 8
"""Where a serialized message of `numbered` has its number [bytes]: after the header, and the length of a sequence."""


def numbered(kind: str) -> Numbered:
    """Return a kind: one of SIZES, or the number of transforms of a TFMessage."""
    if kind in SIZES:
        array = octets(SIZES[kind])

        def array_of(number: int) -> UInt8MultiArray:
            array.layout.data_offset = number
            return array

        return Numbered(UInt8MultiArray, array_of, lambda message: int(message.layout.data_offset))
    transforms = tf_message(int(kind))

    def transforms_of(number: int) -> TFMessage:
        transforms.transforms[0].header.stamp.sec = number
        return transforms

    return Numbered(TFMessage, transforms_of, lambda message: int(message.transforms[0].header.stamp.sec))
