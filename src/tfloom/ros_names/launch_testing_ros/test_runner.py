"""Launches with tests, for nodes."""

from tfloom.launch.testing.ros.test_runner import LaunchTestRunner as LaunchTestRunner
