"""Helpers of tests."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_testing.util import proc_lookup as proc_lookup
    from tfloom.launch.testing.keep_alive import KeepAliveProc as KeepAliveProc
    from tfloom.launch.testing.proc_lookup import NO_CMD_ARGS as NO_CMD_ARGS
    from tfloom.launch.testing.proc_lookup import NoMatchingProcessException as NoMatchingProcessException
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        proc_lookup="launch_testing.util",
        KeepAliveProc="tfloom.launch.testing.keep_alive",
        NO_CMD_ARGS="tfloom.launch.testing.proc_lookup",
        NoMatchingProcessException="tfloom.launch.testing.proc_lookup",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
