"""TFMessage as types of cyclonedds. No postponed annotations here, because cyclonedds reads them as types."""

from dataclasses import dataclass

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, int32, sequence, uint32


@dataclass
class IdlTime(IdlStruct):
    sec: int32
    nanosec: uint32


@dataclass
class IdlHeader(IdlStruct):
    stamp: IdlTime
    frame_id: str


@dataclass
class IdlVector3(IdlStruct):
    x: float64
    y: float64
    z: float64


@dataclass
class IdlQuaternion(IdlStruct):
    x: float64
    y: float64
    z: float64
    w: float64


@dataclass
class IdlTransform(IdlStruct):
    translation: IdlVector3
    rotation: IdlQuaternion


@dataclass
class IdlTransformStamped(IdlStruct):
    header: IdlHeader
    child_frame_id: str
    transform: IdlTransform


@dataclass
class IdlTFMessage(IdlStruct):
    transforms: sequence[IdlTransformStamped]
