"""The interfaces of trajectory_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from trajectory_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("trajectory_msgs")
