"""The recorded output of processes."""

from typing import TYPE_CHECKING

from tfloom.launch.testing.assert_output import assertInStream as assertInStream
from tfloom.launch.testing.io_handler import ActiveIoHandler as ActiveIoHandler
from tfloom.launch.testing.io_handler import IoHandler as IoHandler
from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException

if TYPE_CHECKING:
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
