"""The classes of moveit_msgs/msg/PlaceLocation, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlaceLocation as PlaceLocation
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlaceLocation

__all__ = ["Metaclass_PlaceLocation", "PlaceLocation"]
