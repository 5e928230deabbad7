"""The launches of a test file."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.loader import LoadTestsFromPythonModule as LoadTestsFromPythonModule
from tfloom.launch.testing.loader import PostShutdownTestLoader as PostShutdownTestLoader
from tfloom.launch.testing.loader import PreShutdownTestLoader as PreShutdownTestLoader
from tfloom.launch.testing.loader import TestRun as TestRun
from tfloom.launch.testing.loader import slim_formatwarning as slim_formatwarning

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ReadyToTest="tfloom.launch.testing.actions.ready",
    )
