"""The classes of rcl_interfaces/srv/DescribeParameters, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters as DescribeParameters
from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters_Event as DescribeParameters_Event
from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters_Request as DescribeParameters_Request
from tfloom.interfaces.rcl_interfaces.srv import DescribeParameters_Response as DescribeParameters_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DescribeParameters
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DescribeParameters_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DescribeParameters_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DescribeParameters_Response

__all__ = ["Metaclass_DescribeParameters", "Metaclass_DescribeParameters_Event", "Metaclass_DescribeParameters_Request", "Metaclass_DescribeParameters_Response", "DescribeParameters", "DescribeParameters_Event", "DescribeParameters_Request", "DescribeParameters_Response"]
