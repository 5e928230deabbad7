"""The classes of control_msgs/srv/QueryCalibrationState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.srv import QueryCalibrationState as QueryCalibrationState
from tfloom_interfaces.interfaces.control_msgs.srv import QueryCalibrationState_Event as QueryCalibrationState_Event
from tfloom_interfaces.interfaces.control_msgs.srv import QueryCalibrationState_Request as QueryCalibrationState_Request
from tfloom_interfaces.interfaces.control_msgs.srv import QueryCalibrationState_Response as QueryCalibrationState_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryCalibrationState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryCalibrationState_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryCalibrationState_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QueryCalibrationState_Response

__all__ = ["Metaclass_QueryCalibrationState", "Metaclass_QueryCalibrationState_Event", "Metaclass_QueryCalibrationState_Request", "Metaclass_QueryCalibrationState_Response", "QueryCalibrationState", "QueryCalibrationState_Event", "QueryCalibrationState_Request", "QueryCalibrationState_Response"]
