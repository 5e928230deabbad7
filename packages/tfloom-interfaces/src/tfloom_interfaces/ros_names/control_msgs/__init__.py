"""The interfaces of control_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from control_msgs import action as action
    from control_msgs import msg as msg
    from control_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("control_msgs")
