"""The classes of nav2_msgs/srv/ClearCostmapAroundPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundPose as ClearCostmapAroundPose
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundPose_Event as ClearCostmapAroundPose_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundPose_Request as ClearCostmapAroundPose_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearCostmapAroundPose_Response as ClearCostmapAroundPose_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundPose_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundPose_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearCostmapAroundPose_Response

__all__ = ["Metaclass_ClearCostmapAroundPose", "Metaclass_ClearCostmapAroundPose_Event", "Metaclass_ClearCostmapAroundPose_Request", "Metaclass_ClearCostmapAroundPose_Response", "ClearCostmapAroundPose", "ClearCostmapAroundPose_Event", "ClearCostmapAroundPose_Request", "ClearCostmapAroundPose_Response"]
