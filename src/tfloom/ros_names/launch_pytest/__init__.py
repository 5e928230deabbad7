"""Launch descriptions as fixtures of pytest."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import launch_pytest.fixture
from tfloom.launch.testing.fixtures.fixture import fixture as fixture

__all__ = [
    "fixture",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_pytest import actions as actions
    from launch_pytest import plugin as plugin
    from launch_pytest import tools as tools
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        actions="launch_pytest",
        plugin="launch_pytest",
        tools="launch_pytest",
    )
