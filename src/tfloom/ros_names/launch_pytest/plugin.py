"""Hooks of pytest for tests beside a launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.fixtures.plugin import get_launch_test_fixture as get_launch_test_fixture
from tfloom.launch.testing.fixtures.plugin import get_launch_test_fixture_scope as get_launch_test_fixture_scope
from tfloom.launch.testing.fixtures.plugin import is_launch_test as is_launch_test
from tfloom.launch.testing.fixtures.plugin import is_shutdown_test as is_shutdown_test
from tfloom.launch.testing.fixtures.plugin import pytest_collection_modifyitems as pytest_collection_modifyitems
from tfloom.launch.testing.fixtures.plugin import pytest_pycollect_makeitem as pytest_pycollect_makeitem
from tfloom.launch.testing.fixtures.plugin import pytest_pyfunc_call as pytest_pyfunc_call
