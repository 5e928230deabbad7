"""The interfaces of action_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from action_msgs import msg as msg
    from action_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("action_msgs")
