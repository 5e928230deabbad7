"""Assertions on the order of output."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.assert_sequential_output import SequentialTextChecker as SequentialTextChecker
from tfloom.launch.testing.assert_sequential_output import assertSequentialStdout as assertSequentialStdout

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.proc_lookup import resolveProcesses as resolveProcesses
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        resolveProcesses="tfloom.launch.testing.proc_lookup",
    )
