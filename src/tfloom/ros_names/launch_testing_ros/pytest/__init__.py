"""Launch tests with nodes, under pytest."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing_ros.pytest import hooks as hooks
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        hooks="launch_testing_ros.pytest",
    )
