"""Descriptions of what actions run."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "Executable",
]

TYPE_CHECKING = False
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
