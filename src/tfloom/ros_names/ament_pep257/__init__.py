"""Test files for their docstrings with pydocstyle."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_pep257 import main as main
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ament_pep257")
