"""The classes of geometry_msgs/msg/PolygonInstance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PolygonInstance as PolygonInstance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PolygonInstance

__all__ = ["Metaclass_PolygonInstance", "PolygonInstance"]
