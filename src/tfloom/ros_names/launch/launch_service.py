"""The engine: it visits descriptions, and handles events in order until nothing is left to do."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_service import LaunchService as LaunchService

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
    from tfloom.launch.events.include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        IncludeLaunchDescription="tfloom.launch.events.include_launch_description",
        OnShutdown="tfloom.launch.event_handlers.on_shutdown",
    )
