"""Test files for their notices of copyright."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_copyright import main as main
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ament_copyright")
