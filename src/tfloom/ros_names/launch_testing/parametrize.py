"""Test descriptions with several sets of arguments."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.parametrize import parametrize as parametrize
