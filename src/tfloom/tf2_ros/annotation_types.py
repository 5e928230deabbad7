"""The types by which tf2_ros's modules annotate, for programs that write them in their own annotations."""

from __future__ import annotations

from typing import TypeAlias, TypeVar, Union

from tfloom.interfaces.geometry_msgs.msg import (
    PointStamped,
    PoseStamped,
    PoseWithCovarianceStamped,
    Vector3Stamped,
)
from tfloom.interfaces.sensor_msgs.msg import PointCloud2

__all__ = [
    "FrameGraphSrvRequest",
    "FrameGraphSrvResponse",
    "LookupTransformGoal",
    "LookupTransformResult",
    "MsgStamped",
    "PyKDLType",
    "TransformableObject",
    "TransformableObjectType",
]

FrameGraphSrvRequest = TypeVar("FrameGraphSrvRequest")
FrameGraphSrvResponse = TypeVar("FrameGraphSrvResponse")
LookupTransformGoal = TypeVar("LookupTransformGoal")
LookupTransformResult = TypeVar("LookupTransformResult")
PyKDLType = TypeVar("PyKDLType")
TransformableObjectType = TypeVar("TransformableObjectType")

MsgStamped: TypeAlias = PointStamped | PoseStamped | PoseWithCovarianceStamped | Vector3Stamped | PointCloud2
"""The messages that a buffer's `transform` takes once their packages are imported."""
TransformableObject: TypeAlias = Union[MsgStamped, PyKDLType]  # noqa: UP007 - evaluated on 3.10
