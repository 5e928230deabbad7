"""The interfaces of service_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from service_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("service_msgs")
