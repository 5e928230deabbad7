"""The interfaces of actionlib_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from actionlib_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("actionlib_msgs")
