"""TF2, turtlesim and the ROS 2 workflow around them, with no ROS install.

`import tfloom` loads next to nothing. The rooms are `tfloom.tf2` (frames over time), `tfloom.rosidl` and
`tfloom.interfaces` (messages), `tfloom.node` (what rclpy exposes), `tfloom.tf2_ros`, `tfloom.turtlesim` and the
commands. Programs import ROS's own names (`rclpy`, `tf2_ros`, `geometry_msgs`): a `tfloom.pth` in site-packages
puts them last on `sys.path`, so that a real ROS always comes first.
"""

from __future__ import annotations

import sys
from pathlib import Path

__version__ = "0.1.0"
__all__ = ["__version__", "use_ros_names"]

_ROS_NAMES = Path(__file__).parent / "ros_names"


def use_ros_names() -> None:
    """Put `rclpy`, `tf2_ros`, `geometry_msgs` and the other ROS names last on `sys.path`.

    Needed only where Python did not read `tfloom.pth` from site-packages: under `-S`, after `pip install
    --target`, or in a notebook whose kernel has been running since before the install. Calling it again does
    nothing.
    """
    path = str(_ROS_NAMES)
    if path not in sys.path:
        sys.path.append(path)
