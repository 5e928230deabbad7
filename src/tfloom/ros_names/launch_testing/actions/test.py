"""Processes that are tests."""

from tfloom.launch.testing.actions.test import Test as Test
