"""The messages of rosbag2_interfaces."""

from tfloom.interfaces.rosbag2_interfaces.msg import *
from tfloom.interfaces.rosbag2_interfaces.msg import __all__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosbag2_interfaces.msg import _read_split_event as _read_split_event
    from rosbag2_interfaces.msg import _write_split_event as _write_split_event
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rosbag2_interfaces.msg")
