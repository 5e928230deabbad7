"""The command launch_test."""

from tfloom.launch.testing.junitxml import unittestResultsToXml as unittestResultsToXml
from tfloom.launch.testing.launch_test import add_arguments as add_arguments
from tfloom.launch.testing.launch_test import main as main
from tfloom.launch.testing.launch_test import parse_arguments as parse_arguments
from tfloom.launch.testing.launch_test import run as run
from tfloom.launch.testing.loader import LoadTestsFromPythonModule as LoadTestsFromPythonModule
from tfloom.launch.testing.print_arguments import (
    print_arguments_of_launch_description as print_arguments_of_launch_description,
)
from tfloom.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
