"""The functions of the command `ros2 launch`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ros2launch import api as api
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        api="ros2launch",
    )
