"""Handlers of the events that launch files react to."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import launch.event_handlers.event_named
from tfloom.launch.event_handlers.event_named import event_named as event_named

__all__ = [
    "OnExecutionComplete",
    "OnIncludeLaunchDescription",
    "OnProcessExit",
    "OnProcessIO",
    "OnProcessStart",
    "OnShutdown",
    "event_named",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.event_handlers import on_action_event_base as on_action_event_base
    from launch.event_handlers import on_execution_complete as on_execution_complete
    from launch.event_handlers import on_include_launch_description as on_include_launch_description
    from launch.event_handlers import on_process_exit as on_process_exit
    from launch.event_handlers import on_process_io as on_process_io
    from launch.event_handlers import on_process_start as on_process_start
    from launch.event_handlers import on_shutdown as on_shutdown
    from tfloom.launch.event_handlers.on_execution_complete import OnExecutionComplete as OnExecutionComplete
    from tfloom.launch.event_handlers.on_include_launch_description import OnIncludeLaunchDescription as OnIncludeLaunchDescription
    from tfloom.launch.event_handlers.on_process_exit import OnProcessExit as OnProcessExit
    from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
    from tfloom.launch.event_handlers.on_process_start import OnProcessStart as OnProcessStart
    from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        OnExecutionComplete="tfloom.launch.event_handlers.on_execution_complete",
        OnIncludeLaunchDescription="tfloom.launch.event_handlers.on_include_launch_description",
        OnProcessExit="tfloom.launch.event_handlers.on_process_exit",
        OnProcessIO="tfloom.launch.event_handlers.on_process_io",
        OnProcessStart="tfloom.launch.event_handlers.on_process_start",
        OnShutdown="tfloom.launch.event_handlers.on_shutdown",
        on_action_event_base="launch.event_handlers",
        on_execution_complete="launch.event_handlers",
        on_include_launch_description="launch.event_handlers",
        on_process_exit="launch.event_handlers",
        on_process_io="launch.event_handlers",
        on_process_start="launch.event_handlers",
        on_shutdown="launch.event_handlers",
    )
