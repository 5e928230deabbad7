"""The classes of rosbag2_interfaces/srv/Snapshot, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.srv import Snapshot as Snapshot
from tfloom.interfaces.rosbag2_interfaces.srv import Snapshot_Event as Snapshot_Event
from tfloom.interfaces.rosbag2_interfaces.srv import Snapshot_Request as Snapshot_Request
from tfloom.interfaces.rosbag2_interfaces.srv import Snapshot_Response as Snapshot_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Snapshot
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Snapshot_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Snapshot_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Snapshot_Response

__all__ = ["Metaclass_Snapshot", "Metaclass_Snapshot_Event", "Metaclass_Snapshot_Request", "Metaclass_Snapshot_Response", "Snapshot", "Snapshot_Event", "Snapshot_Request", "Snapshot_Response"]
