"""Test descriptions with several sets of arguments."""

from tfloom.launch.testing.parametrize import parametrize as parametrize
