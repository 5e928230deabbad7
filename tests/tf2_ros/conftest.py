"""A context on the in-process wire, and messages."""

from __future__ import annotations

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from tfloom.interfaces.std_msgs.msg import Header

SECOND = 1_000_000_000


def transform_stamped(
    frame_id: str,
    child_frame_id: str,
    stamp_ns: int,
    xyz: tuple[float, ...] = (1.0, 2.0, 3.0),
    xyzw: tuple[float, ...] = (0.0, 0.0, 0.0, 1.0),
) -> TransformStamped:
    sec, nanosec = divmod(stamp_ns, SECOND)
    return TransformStamped(
        header=Header(stamp=TimeMessage(sec=sec, nanosec=nanosec), frame_id=frame_id),
        child_frame_id=child_frame_id,
        transform=Transform(
            translation=Vector3(x=xyz[0], y=xyz[1], z=xyz[2]),
            rotation=Quaternion(x=xyzw[0], y=xyzw[1], z=xyzw[2], w=xyzw[3]),
        ),
    )
