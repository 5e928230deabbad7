"""The services of sensor_msgs."""

from tfloom.interfaces.sensor_msgs.srv import *
from tfloom.interfaces.sensor_msgs.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from sensor_msgs.srv import _set_camera_info as _set_camera_info
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("sensor_msgs.srv")
