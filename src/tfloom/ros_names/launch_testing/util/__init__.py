"""Helpers of tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "KeepAliveProc",
    "NO_CMD_ARGS",
    "NoMatchingProcessException",
    "resolveProcesses",
]

TYPE_CHECKING = False
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
        KeepAliveProc="tfloom.launch.testing.keep_alive",
        NO_CMD_ARGS="tfloom.launch.testing.proc_lookup",
        NoMatchingProcessException="tfloom.launch.testing.proc_lookup",
        proc_lookup="launch_testing.util",
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
