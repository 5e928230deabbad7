"""The interfaces of lifecycle_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from lifecycle_msgs import msg as msg
    from lifecycle_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("lifecycle_msgs")
