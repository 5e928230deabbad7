"""The classes of nav_msgs/msg/MapMetaData, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.msg import MapMetaData as MapMetaData
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MapMetaData

__all__ = ["Metaclass_MapMetaData", "MapMetaData"]
