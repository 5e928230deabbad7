"""Launch tests with nodes, under pytest."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_testing_ros.pytest import hooks as hooks
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("launch_testing_ros.pytest")
