"""TF2, turtlesim and the ROS 2 workflow around them, with no ROS installed.

`import tfloom` loads almost nothing. The rooms are `tfloom.tf2` (frames over time), `tfloom.rosidl` and
`tfloom.interfaces` (messages), `tfloom.node` (rclpy's classes), `tfloom.tf2_ros`, `tfloom.turtlesim`, `tfloom.robot`
and the commands. Programs import ROS's own names (`rclpy`, `tf2_ros`, `geometry_msgs`): a `tfloom.pth` in
site-packages puts them last on `sys.path`, so that a real ROS always takes precedence.

tfloom has a plug-in of pytest, whose assertions are not rewritten: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

import os
import sys

__version__ = "0.1.0"
__all__ = ["__version__", "use_ros_names"]

_ROS_NAMES = os.path.join(os.path.dirname(__file__), "ros_names")  # noqa: PTH118, PTH120 pathlib costs 5 ms


def use_ros_names() -> None:
    """Put `rclpy`, `tf2_ros`, `geometry_msgs` and the other ROS names last on `sys.path`.

    Packages on AMENT_PREFIX_PATH that hold definitions can be imported, too, if nothing else has their names.

    Needed only where Python did not read `tfloom.pth` from site-packages: under `-S`, after `pip install
    --target`, or in a notebook whose kernel has been running since before the install. Calling it again does
    nothing.
    """
    from tfloom.distributions import installed_prefixes
    from tfloom.ros_finder import install

    folders = [_ROS_NAMES, *(str(prefix / "ros_names") for prefix in installed_prefixes())]
    sys.path += [folder for folder in folders if folder not in sys.path]
    install()
