"""Launch tests under pytest."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_testing.pytest import hooks as hooks
    from launch_testing.pytest import hookspecs as hookspecs
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        hooks="launch_testing.pytest",
        hookspecs="launch_testing.pytest",
    )
