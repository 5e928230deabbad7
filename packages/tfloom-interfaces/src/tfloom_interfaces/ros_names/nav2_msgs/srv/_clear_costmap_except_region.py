"""The classes of nav2_msgs/srv/ClearCostmapExceptRegion, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapExceptRegion as ClearCostmapExceptRegion
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapExceptRegion_Event as ClearCostmapExceptRegion_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapExceptRegion_Request as ClearCostmapExceptRegion_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapExceptRegion_Response as ClearCostmapExceptRegion_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapExceptRegion
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapExceptRegion_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapExceptRegion_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapExceptRegion_Response

__all__ = ["Metaclass_ClearCostmapExceptRegion", "Metaclass_ClearCostmapExceptRegion_Event", "Metaclass_ClearCostmapExceptRegion_Request", "Metaclass_ClearCostmapExceptRegion_Response", "ClearCostmapExceptRegion", "ClearCostmapExceptRegion_Event", "ClearCostmapExceptRegion_Request", "ClearCostmapExceptRegion_Response"]
