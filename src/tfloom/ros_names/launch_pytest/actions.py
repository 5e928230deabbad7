"""Actions of tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.actions.ready import ReadyToTest as ReadyToTest
