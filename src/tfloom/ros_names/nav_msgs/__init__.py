"""The interfaces of nav_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nav_msgs import msg as msg
    from nav_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nav_msgs")
