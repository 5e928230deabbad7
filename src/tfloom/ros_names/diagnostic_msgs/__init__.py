"""The interfaces of diagnostic_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from diagnostic_msgs import msg as msg
    from diagnostic_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("diagnostic_msgs")
