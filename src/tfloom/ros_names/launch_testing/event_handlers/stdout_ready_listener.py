"""Actions that follow a line of output."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.stdout_ready_listener import StdoutReadyListener as StdoutReadyListener

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
    from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecuteProcess="tfloom.launch.actions.execute_process",
        OnProcessIO="tfloom.launch.event_handlers.on_process_io",
        SomeEntitiesType="tfloom.launch.some_entities_type",
    )
