"""The interfaces of unique_identifier_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from unique_identifier_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("unique_identifier_msgs")
