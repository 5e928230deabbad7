"""Test files for their notices of copyright."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_copyright import main as main
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        main="ament_copyright",
    )
