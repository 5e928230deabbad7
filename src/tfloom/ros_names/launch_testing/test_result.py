"""Results of launches."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.test_result import FailResult as FailResult
from tfloom.launch.testing.test_result import SkipResult as SkipResult
from tfloom.launch.testing.test_result import TestResult as TestResult
