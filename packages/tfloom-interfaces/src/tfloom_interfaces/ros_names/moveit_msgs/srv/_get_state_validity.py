"""The classes of moveit_msgs/srv/GetStateValidity, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import GetStateValidity as GetStateValidity
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetStateValidity_Event as GetStateValidity_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetStateValidity_Request as GetStateValidity_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import GetStateValidity_Response as GetStateValidity_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetStateValidity
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetStateValidity_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetStateValidity_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GetStateValidity_Response

__all__ = ["Metaclass_GetStateValidity", "Metaclass_GetStateValidity_Event", "Metaclass_GetStateValidity_Request", "Metaclass_GetStateValidity_Response", "GetStateValidity", "GetStateValidity_Event", "GetStateValidity_Request", "GetStateValidity_Response"]
