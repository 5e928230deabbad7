"""The messages of the measurements."""

from __future__ import annotations

from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from std_msgs.msg import Header, UInt8MultiArray
from tf2_msgs.msg import TFMessage

TEXT = "Hello World: 0"
SIZES = {"64 kB": 64_000, "1 MB": 1_000_000}


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
