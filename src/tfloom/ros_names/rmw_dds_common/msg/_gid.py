"""The classes of rmw_dds_common/msg/Gid, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rmw_dds_common.msg import Gid as Gid
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gid

__all__ = ["Metaclass_Gid", "Gid"]
