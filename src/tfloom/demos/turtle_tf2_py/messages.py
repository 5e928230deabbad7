"""turtlesim's interfaces that the demos use, by their name in the distribution that is followed.

Demos import no other room of their shelf, so `tfloom.turtlesim.messages` does the same for the simulator.
"""

from __future__ import annotations

from tfloom.ros_imports.ros_distro import TURTLESIM_PACKAGE

TYPE_CHECKING = False
if TYPE_CHECKING or TURTLESIM_PACKAGE == "turtlesim":
    from tfloom.interfaces.turtlesim.msg import Pose
    from tfloom.interfaces.turtlesim.srv import Spawn
else:
    from tfloom.interfaces.turtlesim_msgs.msg import Pose
    from tfloom.interfaces.turtlesim_msgs.srv import Spawn

__all__ = ["Pose", "Spawn"]
