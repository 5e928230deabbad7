"""Actions of tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "GTest",
    "PyTest",
    "ReadyToTest",
    "Test",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.actions import gtest as gtest
    from launch_testing.actions import pytest as pytest
    from launch_testing.actions import ready as ready
    from launch_testing.actions import test as test
    from tfloom.launch.testing.actions.gtest import GTest as GTest
    from tfloom.launch.testing.actions.pytest import PyTest as PyTest
    from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest
    from tfloom.launch.testing.actions.test import Test as Test
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        GTest="tfloom.launch.testing.actions.gtest",
        PyTest="tfloom.launch.testing.actions.pytest",
        ReadyToTest="tfloom.launch.testing.actions.ready",
        Test="tfloom.launch.testing.actions.test",
        gtest="launch_testing.actions",
        pytest="launch_testing.actions",
        ready="launch_testing.actions",
        test="launch_testing.actions",
    )
