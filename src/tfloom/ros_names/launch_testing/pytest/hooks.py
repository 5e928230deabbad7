"""Hooks of pytest for launch tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.hooks import LaunchTestFailure as LaunchTestFailure
from tfloom.launch.testing.hooks import LaunchTestFailureRepr as LaunchTestFailureRepr
from tfloom.launch.testing.hooks import LaunchTestItem as LaunchTestItem
from tfloom.launch.testing.hooks import LaunchTestModule as LaunchTestModule
from tfloom.launch.testing.hooks import find_launch_test_entrypoint as find_launch_test_entrypoint
from tfloom.launch.testing.hooks import pytest_launch_collect_makemodule as pytest_launch_collect_makemodule

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.loader import LoadTestsFromPythonModule as LoadTestsFromPythonModule
    from tfloom.launch.testing.plugin import pytest_addhooks as pytest_addhooks
    from tfloom.launch.testing.plugin import pytest_addoption as pytest_addoption
    from tfloom.launch.testing.plugin import pytest_configure as pytest_configure
    from tfloom.launch.testing.plugin import pytest_pycollect_makemodule as pytest_pycollect_makemodule
    from tfloom.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchTestRunner="tfloom.launch.testing.test_runner",
        LoadTestsFromPythonModule="tfloom.launch.testing.loader",
        pytest_addhooks="tfloom.launch.testing.plugin",
        pytest_addoption="tfloom.launch.testing.plugin",
        pytest_configure="tfloom.launch.testing.plugin",
        pytest_pycollect_makemodule="tfloom.launch.testing.plugin",
    )
