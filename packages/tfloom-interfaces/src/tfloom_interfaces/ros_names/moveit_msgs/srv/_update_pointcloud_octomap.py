"""The classes of moveit_msgs/srv/UpdatePointcloudOctomap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.srv import UpdatePointcloudOctomap as UpdatePointcloudOctomap
from tfloom_interfaces.interfaces.moveit_msgs.srv import UpdatePointcloudOctomap_Event as UpdatePointcloudOctomap_Event
from tfloom_interfaces.interfaces.moveit_msgs.srv import UpdatePointcloudOctomap_Request as UpdatePointcloudOctomap_Request
from tfloom_interfaces.interfaces.moveit_msgs.srv import UpdatePointcloudOctomap_Response as UpdatePointcloudOctomap_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdatePointcloudOctomap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdatePointcloudOctomap_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdatePointcloudOctomap_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UpdatePointcloudOctomap_Response

__all__ = ["Metaclass_UpdatePointcloudOctomap", "Metaclass_UpdatePointcloudOctomap_Event", "Metaclass_UpdatePointcloudOctomap_Request", "Metaclass_UpdatePointcloudOctomap_Response", "UpdatePointcloudOctomap", "UpdatePointcloudOctomap_Event", "UpdatePointcloudOctomap_Request", "UpdatePointcloudOctomap_Response"]
