"""Launches with tests, for nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.test_runner import LaunchTestRunner as LaunchTestRunner
