"""The interfaces of moveit_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from moveit_msgs import action as action
    from moveit_msgs import msg as msg
    from moveit_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("moveit_msgs")
