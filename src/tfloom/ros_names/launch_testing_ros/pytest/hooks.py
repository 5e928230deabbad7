"""Hooks of pytest for launch tests with nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.hooks import LaunchROSTestItem as LaunchROSTestItem
from tfloom.launch.testing.ros.hooks import LaunchROSTestModule as LaunchROSTestModule

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.hooks import LaunchTestItem as LaunchTestItem
    from tfloom.launch.testing.hooks import LaunchTestModule as LaunchTestModule
    from tfloom.launch.testing.ros.test_runner import LaunchTestRunner as LaunchTestRunner
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchTestItem="tfloom.launch.testing.hooks",
        LaunchTestModule="tfloom.launch.testing.hooks",
        LaunchTestRunner="tfloom.launch.testing.ros.test_runner",
    )
