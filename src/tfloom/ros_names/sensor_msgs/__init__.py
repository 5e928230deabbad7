"""The interfaces of sensor_msgs."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from sensor_msgs import msg as msg
    from sensor_msgs import srv as srv
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("sensor_msgs")
