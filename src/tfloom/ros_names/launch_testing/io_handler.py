"""The recorded output of processes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.io_handler import ActiveIoHandler as ActiveIoHandler
from tfloom.launch.testing.io_handler import IoHandler as IoHandler

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.assert_output import assertInStream as assertInStream
    from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NoMatchingProcessException="tfloom.launch.testing.proc_lookup",
        assertInStream="tfloom.launch.testing.assert_output",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
