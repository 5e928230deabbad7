"""The interfaces of shape_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from shape_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("shape_msgs")
