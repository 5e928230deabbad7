"""The classes of rmw_dds_common/msg/NodeEntitiesInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rmw_dds_common.msg import NodeEntitiesInfo as NodeEntitiesInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_NodeEntitiesInfo

__all__ = ["Metaclass_NodeEntitiesInfo", "NodeEntitiesInfo"]
