"""Execute a process on this host."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.execute_local import ExecuteLocal as ExecuteLocal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.timer_action import TimerAction as TimerAction
    from tfloom.launch.event_handlers.on_process_exit import OnProcessExit as OnProcessExit
    from tfloom.launch.substitutions.launch_configuration import LaunchConfiguration as LaunchConfiguration
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchConfiguration="tfloom.launch.substitutions.launch_configuration",
        OnProcessExit="tfloom.launch.event_handlers.on_process_exit",
        TimerAction="tfloom.launch.actions.timer_action",
    )
