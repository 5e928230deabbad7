"""The interfaces of ackermann_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ackermann_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("ackermann_msgs")
