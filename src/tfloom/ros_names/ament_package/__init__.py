"""Templates of packages."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_package import templates as templates
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        templates="ament_package",
    )
