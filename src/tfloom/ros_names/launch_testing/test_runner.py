"""Launches with tests."""

from tfloom.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
