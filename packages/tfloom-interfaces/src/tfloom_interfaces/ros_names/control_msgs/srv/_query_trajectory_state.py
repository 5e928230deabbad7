"""The classes of control_msgs/srv/QueryTrajectoryState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.srv import QueryTrajectoryState as QueryTrajectoryState
from tfloom_interfaces.interfaces.control_msgs.srv import QueryTrajectoryState_Event as QueryTrajectoryState_Event
from tfloom_interfaces.interfaces.control_msgs.srv import QueryTrajectoryState_Request as QueryTrajectoryState_Request
from tfloom_interfaces.interfaces.control_msgs.srv import QueryTrajectoryState_Response as QueryTrajectoryState_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryTrajectoryState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryTrajectoryState_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryTrajectoryState_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryTrajectoryState_Response

__all__ = ["Metaclass_QueryTrajectoryState", "Metaclass_QueryTrajectoryState_Event", "Metaclass_QueryTrajectoryState_Request", "Metaclass_QueryTrajectoryState_Response", "QueryTrajectoryState", "QueryTrajectoryState_Event", "QueryTrajectoryState_Request", "QueryTrajectoryState_Response"]
