"""The transform between two frames, as lines of text."""

from __future__ import annotations

import math

from tfloom.common.terminal import shown_name
from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException
from tfloom.tf2_tools.text.transform import matrix_from_quaternion, rpy_from_matrix


def follow_lines(buffer: Buffer, pair: tuple[str, str], now_ns: int) -> list[str]:
    """Return the newest transform that takes data from the source into the target frame, or why there is none.

    Args:
        buffer: The buffer with both frames.
        pair: Target and source frame.
        now_ns: The time with which its stamp is compared [ns since epoch].
    """
    target, source = pair
    heading = f"{shown_name(target)} from {shown_name(source)}"
    try:
        transform = buffer.lookup(target, source)
    except TransformException as error:
        return [heading, f"  {shown_name(str(error).splitlines()[0])}", ""]
    x, y, z = transform.translation
    angles = rpy_from_matrix(matrix_from_quaternion(transform.rotation_xyzw))
    roll, pitch, yaw = (round(math.degrees(angle), 2) + 0.0 for angle in angles)  # no -0.00
    age = f"age {(now_ns - transform.stamp_ns) / 1e9:.3f} s" if transform.stamp_ns else "static"
    return [
        f"{heading}  {age}",
        f"  translation [m]    x {x:+9.3f}  y {y:+9.3f}  z {z:+9.3f}   distance {math.hypot(x, y, z):.3f}",
        f"  rotation   [deg]   roll {roll:+8.2f}  pitch {pitch:+8.2f}  yaw {yaw:+8.2f}",
    ]
