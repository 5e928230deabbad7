"""The messages of nmea_msgs."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import *
from tfloom_interfaces.interfaces.nmea_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from nmea_msgs.msg import _gpgga as _gpgga
    from nmea_msgs.msg import _gpgsa as _gpgsa
    from nmea_msgs.msg import _gpgst as _gpgst
    from nmea_msgs.msg import _gpgsv as _gpgsv
    from nmea_msgs.msg import _gpgsv_satellite as _gpgsv_satellite
    from nmea_msgs.msg import _gprmc as _gprmc
    from nmea_msgs.msg import _gpvtg as _gpvtg
    from nmea_msgs.msg import _gpzda as _gpzda
    from nmea_msgs.msg import _sentence as _sentence
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("nmea_msgs.msg")
