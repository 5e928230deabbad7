"""The interfaces of geometry_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from geometry_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("geometry_msgs")
