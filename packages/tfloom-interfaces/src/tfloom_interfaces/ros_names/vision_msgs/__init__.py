"""The interfaces of vision_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from vision_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("vision_msgs")
