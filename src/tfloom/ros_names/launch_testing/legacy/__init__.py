"""The older way to test a launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "EmitEvent",
    "ExecuteProcess",
    "LaunchTestService",
    "OnExecutionComplete",
    "OnProcessExit",
    "OnProcessIO",
    "OnShutdown",
    "RegisterEventHandler",
    "Shutdown",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.legacy import output as output
    from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
    from tfloom.launch.event_handlers.on_execution_complete import OnExecutionComplete as OnExecutionComplete
    from tfloom.launch.event_handlers.on_process_exit import OnProcessExit as OnProcessExit
    from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
    from tfloom.launch.event_handlers.on_shutdown import OnShutdown as OnShutdown
    from tfloom.launch.events.shutdown import Shutdown as Shutdown
    from tfloom.launch.testing.legacy import LaunchTestService as LaunchTestService
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EmitEvent="tfloom.launch.actions.emit_event",
        ExecuteProcess="tfloom.launch.actions.execute_process",
        LaunchTestService="tfloom.launch.testing.legacy",
        OnExecutionComplete="tfloom.launch.event_handlers.on_execution_complete",
        OnProcessExit="tfloom.launch.event_handlers.on_process_exit",
        OnProcessIO="tfloom.launch.event_handlers.on_process_io",
        OnShutdown="tfloom.launch.event_handlers.on_shutdown",
        RegisterEventHandler="tfloom.launch.actions.register_event_handler",
        Shutdown="tfloom.launch.events.shutdown",
        output="launch_testing.legacy",
    )
