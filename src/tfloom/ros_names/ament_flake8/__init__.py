"""Test files for their style with flake8."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_flake8 import main as main
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ament_flake8")
