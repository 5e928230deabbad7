"""The classes of rmw_dds_common/msg/ParticipantEntitiesInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rmw_dds_common.msg import ParticipantEntitiesInfo as ParticipantEntitiesInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParticipantEntitiesInfo

__all__ = ["Metaclass_ParticipantEntitiesInfo", "ParticipantEntitiesInfo"]
