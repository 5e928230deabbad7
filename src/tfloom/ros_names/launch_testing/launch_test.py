"""The command launch_test."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.launch_test import add_arguments as add_arguments
from tfloom.launch.testing.launch_test import main as main
from tfloom.launch.testing.launch_test import parse_arguments as parse_arguments
from tfloom.launch.testing.launch_test import run as run

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.junitxml import unittestResultsToXml as unittestResultsToXml
    from tfloom.launch.testing.loader import LoadTestsFromPythonModule as LoadTestsFromPythonModule
    from tfloom.launch.testing.print_arguments import print_arguments_of_launch_description as print_arguments_of_launch_description
    from tfloom.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchTestRunner="tfloom.launch.testing.test_runner",
        LoadTestsFromPythonModule="tfloom.launch.testing.loader",
        print_arguments_of_launch_description="tfloom.launch.testing.print_arguments",
        unittestResultsToXml="tfloom.launch.testing.junitxml",
    )
