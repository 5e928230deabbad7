"""Processes that are tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.actions.test import Test as Test
