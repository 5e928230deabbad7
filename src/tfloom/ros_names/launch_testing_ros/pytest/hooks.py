"""Hooks of pytest for launch tests with nodes."""

from tfloom.launch.testing.hooks import LaunchTestItem as LaunchTestItem
from tfloom.launch.testing.hooks import LaunchTestModule as LaunchTestModule
from tfloom.launch.testing.ros.hooks import LaunchROSTestItem as LaunchROSTestItem
from tfloom.launch.testing.ros.hooks import LaunchROSTestModule as LaunchROSTestModule
from tfloom.launch.testing.ros.test_runner import LaunchTestRunner as LaunchTestRunner
