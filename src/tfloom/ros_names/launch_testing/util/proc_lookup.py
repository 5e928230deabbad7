"""The processes that a test names."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NO_CMD_ARGS="tfloom.launch.testing.proc_lookup",
    )
