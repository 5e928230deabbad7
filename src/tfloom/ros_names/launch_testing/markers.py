"""Marks of test descriptions and tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.markers import keep_alive as keep_alive
from tfloom.launch.testing.markers import retry_on_failure as retry_on_failure
