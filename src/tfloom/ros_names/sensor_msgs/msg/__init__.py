"""The messages of sensor_msgs."""

from tfloom.interfaces.sensor_msgs.msg import *
from tfloom.interfaces.sensor_msgs.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from sensor_msgs.msg import _battery_state as _battery_state
    from sensor_msgs.msg import _camera_info as _camera_info
    from sensor_msgs.msg import _channel_float32 as _channel_float32
    from sensor_msgs.msg import _compressed_image as _compressed_image
    from sensor_msgs.msg import _fluid_pressure as _fluid_pressure
    from sensor_msgs.msg import _illuminance as _illuminance
    from sensor_msgs.msg import _image as _image
    from sensor_msgs.msg import _imu as _imu
    from sensor_msgs.msg import _joint_state as _joint_state
    from sensor_msgs.msg import _joy as _joy
    from sensor_msgs.msg import _joy_feedback as _joy_feedback
    from sensor_msgs.msg import _joy_feedback_array as _joy_feedback_array
    from sensor_msgs.msg import _laser_echo as _laser_echo
    from sensor_msgs.msg import _laser_scan as _laser_scan
    from sensor_msgs.msg import _magnetic_field as _magnetic_field
    from sensor_msgs.msg import _multi_dof_joint_state as _multi_dof_joint_state
    from sensor_msgs.msg import _multi_echo_laser_scan as _multi_echo_laser_scan
    from sensor_msgs.msg import _nav_sat_fix as _nav_sat_fix
    from sensor_msgs.msg import _nav_sat_status as _nav_sat_status
    from sensor_msgs.msg import _point_cloud as _point_cloud
    from sensor_msgs.msg import _point_cloud2 as _point_cloud2
    from sensor_msgs.msg import _point_field as _point_field
    from sensor_msgs.msg import _range as _range
    from sensor_msgs.msg import _region_of_interest as _region_of_interest
    from sensor_msgs.msg import _relative_humidity as _relative_humidity
    from sensor_msgs.msg import _temperature as _temperature
    from sensor_msgs.msg import _time_reference as _time_reference
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("sensor_msgs.msg")
