"""The classes of tf2_msgs/srv/FrameGraph, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
from tfloom.interfaces.tf2_msgs.srv import FrameGraph_Event as FrameGraph_Event
from tfloom.interfaces.tf2_msgs.srv import FrameGraph_Request as FrameGraph_Request
from tfloom.interfaces.tf2_msgs.srv import FrameGraph_Response as FrameGraph_Response
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FrameGraph
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FrameGraph_Event
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FrameGraph_Request
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FrameGraph_Response

__all__ = ["Metaclass_FrameGraph", "Metaclass_FrameGraph_Event", "Metaclass_FrameGraph_Request", "Metaclass_FrameGraph_Response", "FrameGraph", "FrameGraph_Event", "FrameGraph_Request", "FrameGraph_Response"]
