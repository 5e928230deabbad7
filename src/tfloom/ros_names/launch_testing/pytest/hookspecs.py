"""The hook for other plug-ins' launch tests."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.hookspecs import pytest_launch_collect_makemodule as pytest_launch_collect_makemodule
