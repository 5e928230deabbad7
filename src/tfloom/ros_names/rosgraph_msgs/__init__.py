"""The interfaces of rosgraph_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosgraph_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rosgraph_msgs")
