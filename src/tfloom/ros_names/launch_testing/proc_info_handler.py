"""The recorded starts and ends of processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.proc_info_handler import ActiveProcInfoHandler as ActiveProcInfoHandler
from tfloom.launch.testing.proc_info_handler import ProcInfoHandler as ProcInfoHandler

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
    from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecuteProcess="tfloom.launch.actions.execute_process",
        NoMatchingProcessException="tfloom.launch.testing.proc_lookup",
        ProcessExited="tfloom.launch.events.process.process_exited",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
