"""turtlesim's interfaces, by their name in the distribution that is followed (`ros_imports/ros_distro.py`).

They are here because the simulator, the demos and their programs use them, and rooms of one shelf do not import each
other.
"""

from __future__ import annotations

from tfloom.ros_imports.ros_distro import TURTLESIM_PACKAGE

TYPE_CHECKING = False
if TYPE_CHECKING or TURTLESIM_PACKAGE == "turtlesim":
    from tfloom.interfaces.turtlesim.action import RotateAbsolute
    from tfloom.interfaces.turtlesim.msg import Color, Pose
    from tfloom.interfaces.turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative
else:
    from tfloom.interfaces.turtlesim_msgs.action import RotateAbsolute
    from tfloom.interfaces.turtlesim_msgs.msg import Color, Pose
    from tfloom.interfaces.turtlesim_msgs.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

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
