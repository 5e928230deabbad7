"""The classes of nav2_msgs/srv/ClearCostmapAroundRobot, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundRobot as ClearCostmapAroundRobot
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundRobot_Event as ClearCostmapAroundRobot_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundRobot_Request as ClearCostmapAroundRobot_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundRobot_Response as ClearCostmapAroundRobot_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundRobot
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundRobot_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundRobot_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundRobot_Response

__all__ = ["Metaclass_ClearCostmapAroundRobot", "Metaclass_ClearCostmapAroundRobot_Event", "Metaclass_ClearCostmapAroundRobot_Request", "Metaclass_ClearCostmapAroundRobot_Response", "ClearCostmapAroundRobot", "ClearCostmapAroundRobot_Event", "ClearCostmapAroundRobot_Request", "ClearCostmapAroundRobot_Response"]
