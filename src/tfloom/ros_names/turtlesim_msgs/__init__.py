"""The interfaces of turtlesim_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from turtlesim_msgs import action as action
    from turtlesim_msgs import msg as msg
    from turtlesim_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("turtlesim_msgs")
