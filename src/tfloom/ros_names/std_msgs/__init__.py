"""The interfaces of std_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from std_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("std_msgs")
