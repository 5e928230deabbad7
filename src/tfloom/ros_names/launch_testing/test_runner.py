"""Launches with tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
