"""The interfaces of tf2_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tf2_msgs import action as action
    from tf2_msgs import msg as msg
    from tf2_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_msgs")
