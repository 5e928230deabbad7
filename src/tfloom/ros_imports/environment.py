"""The variables that a sourced ROS sets: programs and conditions in package.xml ask for them.

They are set where a ROS would be sourced: in the scripts that `colcon build` writes, for what `ros2 run` and
`ros2 launch` start, and for a program that imports tfloom's `rclpy`. A value that is there stays.
"""

from __future__ import annotations

import os

from tfloom.ros_imports.ros_distro import ROS_DISTRO

__all__ = ["ROS_ENVIRONMENT", "set_ros_environment"]

ROS_ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": ROS_DISTRO}


def set_ros_environment() -> None:
    """Set the variables for this process and those that it starts, each unless it has a value."""
    for name, value in ROS_ENVIRONMENT.items():
        os.environ.setdefault(name, value)
