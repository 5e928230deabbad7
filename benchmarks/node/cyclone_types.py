# No `from __future__ import annotations`, because cyclonedds reads the annotations as types.
"""Messages of ROS as types of cyclonedds' Python API."""

from dataclasses import dataclass

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, int32, int64, sequence, uint8, uint32


@dataclass
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


@dataclass
class Bytes(IdlStruct, typename="bench.Bytes"):
    number: uint32
    data: sequence[uint8]


@dataclass
class Payload(IdlStruct, typename="bench.Payload"):
    data: sequence[uint8]


@dataclass
class Dimension(IdlStruct, typename="std_msgs::msg::dds_::MultiArrayDimension_"):
    label: str
    size: uint32
    stride: uint32


@dataclass
class Layout(IdlStruct, typename="std_msgs::msg::dds_::MultiArrayLayout_"):
    dim: sequence[Dimension]
    data_offset: uint32


@dataclass
class UInt8MultiArray(IdlStruct, typename="std_msgs::msg::dds_::UInt8MultiArray_"):
    layout: Layout
    data: sequence[uint8]


@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32
    nanosec: uint32


@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64
    y: float64
    z: float64


@dataclass
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64
    y: float64
    z: float64
    w: float64


@dataclass
class Transform(IdlStruct, typename="geometry_msgs::msg::dds_::Transform_"):
    translation: Vector3
    rotation: Quaternion


@dataclass
class TransformStamped(IdlStruct, typename="geometry_msgs::msg::dds_::TransformStamped_"):
    header: Header
    child_frame_id: str
    transform: Transform


@dataclass
class TFMessage(IdlStruct, typename="tf2_msgs::msg::dds_::TFMessage_"):
    transforms: sequence[TransformStamped]


@dataclass
class Request(IdlStruct, typename="bench.Request"):
    client: int64
    number: int64
    a: int64
    b: int64


@dataclass
class Response(IdlStruct, typename="bench.Response"):
    client: int64
    number: int64
    sum: int64


def tf_message(transforms: int, stamp: Time) -> TFMessage:
    """Return a message equal to that of `messages.tf_message`."""
    pose = Transform(Vector3(1.5, -0.25, 0.125), Quaternion(0.0, 0.0, 0.6, 0.8))
    return TFMessage([TransformStamped(Header(stamp, "base"), f"joint_{i}", pose) for i in range(transforms)])
