"""The hook for other plug-ins' launch tests."""

from tfloom.launch.testing.hookspecs import (
    pytest_launch_collect_makemodule as pytest_launch_collect_makemodule,
)
