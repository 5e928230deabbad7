"""Descriptions of what actions run."""

from typing import TYPE_CHECKING

__all__ = ["Executable"]

if TYPE_CHECKING:
    from launch.descriptions import executable as executable
    from tfloom.launch.descriptions.executable import Executable as Executable
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Executable="tfloom.launch.descriptions.executable",
        executable="launch.descriptions",
    )
