"""Launch tests under pytest."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_testing.pytest import hooks as hooks
    from launch_testing.pytest import hookspecs as hookspecs
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("launch_testing.pytest")
