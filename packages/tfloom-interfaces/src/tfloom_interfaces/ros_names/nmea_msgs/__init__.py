"""The interfaces of nmea_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nmea_msgs import msg as msg
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nmea_msgs")
