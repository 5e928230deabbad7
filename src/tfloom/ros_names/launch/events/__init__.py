"""Events that the launch itself emits or handles."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ExecutionComplete",
    "IncludeLaunchDescription",
    "Shutdown",
    "TimerEvent",
    "matches_action",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.events import execution_complete as execution_complete
    from launch.events import include_launch_description as include_launch_description
    from launch.events import matchers as matchers
    from launch.events import process as process
    from launch.events import shutdown as shutdown
    from launch.events import timer_event as timer_event
    from tfloom.launch.events.execution_complete import ExecutionComplete as ExecutionComplete
    from tfloom.launch.events.include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
    from tfloom.launch.events.matchers import matches_action as matches_action
    from tfloom.launch.events.shutdown import Shutdown as Shutdown
    from tfloom.launch.events.timer_event import TimerEvent as TimerEvent
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecutionComplete="tfloom.launch.events.execution_complete",
        IncludeLaunchDescription="tfloom.launch.events.include_launch_description",
        Shutdown="tfloom.launch.events.shutdown",
        TimerEvent="tfloom.launch.events.timer_event",
        execution_complete="launch.events",
        include_launch_description="launch.events",
        matchers="launch.events",
        matches_action="tfloom.launch.events.matchers",
        process="launch.events",
        shutdown="launch.events",
        timer_event="launch.events",
    )
