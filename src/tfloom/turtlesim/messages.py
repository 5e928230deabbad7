"""turtlesim's interfaces, by their name in the distribution of ROS_DISTRO.

From Kilted on the name is `turtlesim_msgs/…`, with the same fields. Without ROS_DISTRO, it is Jazzy's.
"""

from __future__ import annotations

import os

FIRST_WITH_OWN_PACKAGE = "kilted"
"""Distributions' names are in alphabetical order; `rolling` is the last."""

if os.environ.get("ROS_DISTRO", "") < FIRST_WITH_OWN_PACKAGE:
    from tfloom.interfaces.turtlesim.action import RotateAbsolute
    from tfloom.interfaces.turtlesim.msg import Color, Pose
    from tfloom.interfaces.turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative
else:
    from tfloom.interfaces.turtlesim_msgs.action import RotateAbsolute  # type: ignore[assignment]
    from tfloom.interfaces.turtlesim_msgs.msg import Color, Pose  # type: ignore[assignment]
    from tfloom.interfaces.turtlesim_msgs.srv import (  # type: ignore[assignment]
        Kill,
        SetPen,
        Spawn,
        TeleportAbsolute,
        TeleportRelative,
    )

__all__ = [
    "Color",
    "Kill",
    "Pose",
    "RotateAbsolute",
    "SetPen",
    "Spawn",
    "TeleportAbsolute",
    "TeleportRelative",
]
