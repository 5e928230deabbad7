"""Templates of packages."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ament_package import templates as templates
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ament_package")
