"""The interfaces of statistics_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from statistics_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("statistics_msgs")
