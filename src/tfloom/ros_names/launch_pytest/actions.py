"""Actions of tests."""

from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest
