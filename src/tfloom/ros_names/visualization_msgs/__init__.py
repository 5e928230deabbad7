"""The interfaces of visualization_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from visualization_msgs import msg as msg
    from visualization_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("visualization_msgs")
