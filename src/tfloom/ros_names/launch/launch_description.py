"""Launch descriptions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description import LaunchDescription as LaunchDescription

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.declare_launch_argument import DeclareLaunchArgument as DeclareLaunchArgument
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DeclareLaunchArgument="tfloom.launch.actions.declare_launch_argument",
        LaunchContext="tfloom.launch.launch_context",
    )
