"""The services of rosbag2_interfaces."""

from tfloom.interfaces.rosbag2_interfaces.srv import *
from tfloom.interfaces.rosbag2_interfaces.srv import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosbag2_interfaces.srv import _burst as _burst
    from rosbag2_interfaces.srv import _get_rate as _get_rate
    from rosbag2_interfaces.srv import _is_paused as _is_paused
    from rosbag2_interfaces.srv import _pause as _pause
    from rosbag2_interfaces.srv import _play as _play
    from rosbag2_interfaces.srv import _play_next as _play_next
    from rosbag2_interfaces.srv import _resume as _resume
    from rosbag2_interfaces.srv import _seek as _seek
    from rosbag2_interfaces.srv import _set_rate as _set_rate
    from rosbag2_interfaces.srv import _snapshot as _snapshot
    from rosbag2_interfaces.srv import _split_bagfile as _split_bagfile
    from rosbag2_interfaces.srv import _stop as _stop
    from rosbag2_interfaces.srv import _toggle_paused as _toggle_paused
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rosbag2_interfaces.srv")
