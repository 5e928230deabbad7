"""The classes of nav2_msgs/srv/ClearEntireCostmap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearEntireCostmap as ClearEntireCostmap
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearEntireCostmap_Event as ClearEntireCostmap_Event
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearEntireCostmap_Request as ClearEntireCostmap_Request
from tfloom_interfaces.interfaces.nav2_msgs.srv import ClearEntireCostmap_Response as ClearEntireCostmap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearEntireCostmap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearEntireCostmap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearEntireCostmap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ClearEntireCostmap_Response

__all__ = ["Metaclass_ClearEntireCostmap", "Metaclass_ClearEntireCostmap_Event", "Metaclass_ClearEntireCostmap_Request", "Metaclass_ClearEntireCostmap_Response", "ClearEntireCostmap", "ClearEntireCostmap_Event", "ClearEntireCostmap_Request", "ClearEntireCostmap_Response"]
