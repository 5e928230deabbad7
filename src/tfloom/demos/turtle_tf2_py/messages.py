"""turtlesim's interfaces that the demos use, by their name in the distribution of ROS_DISTRO.

From Kilted on the name is `turtlesim_msgs/…`; tfloom's turtlesim follows the same rule.
"""

from __future__ import annotations

import os

if os.environ.get("ROS_DISTRO", "") < "kilted":
    from tfloom.interfaces.turtlesim.msg import Pose
    from tfloom.interfaces.turtlesim.srv import Spawn
else:
    from tfloom.interfaces.turtlesim_msgs.msg import Pose  # type: ignore[assignment]
    from tfloom.interfaces.turtlesim_msgs.srv import Spawn  # type: ignore[assignment]

__all__ = ["Pose", "Spawn"]
