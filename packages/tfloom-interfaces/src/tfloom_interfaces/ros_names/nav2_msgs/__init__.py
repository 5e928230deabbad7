"""The interfaces of nav2_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav2_msgs import action as action
    from nav2_msgs import msg as msg
    from nav2_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav2_msgs")
