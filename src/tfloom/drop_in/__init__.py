"""tf2_ros's buffer and listener for the nodes of a real rclpy: `from tfloom.drop_in import Buffer, TransformListener`.

Where `rclpy` is tfloom's, these are the classes of `tfloom.tf2_ros`, so that a program runs in both places.

- buffer, transform_listener: tf2_ros for nodes of a real rclpy
- sources: a reader beside the node, or a raw subscription
- errors: also tf2_py's
- real_ros: that ROS's names
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tfloom.drop_in.errors import (
    BackwardExtrapolationException,
    ConnectivityException,
    ExtrapolationException,
    ForwardExtrapolationException,
    InvalidArgumentException,
    LookupException,
    NoDataForExtrapolationException,
    TimeoutException,
    TransformException,
)
from tfloom.drop_in.real_ros import has_rclpy

if TYPE_CHECKING or has_rclpy():
    from tfloom.drop_in.buffer import Buffer
    from tfloom.drop_in.transform_listener import StaticTransformListener, TransformListener
else:
    from tfloom.drop_in.tfloom_listener import StaticTransformListener, TransformListener
    from tfloom.tf2_ros.buffer import Buffer

__all__ = [
    "BackwardExtrapolationException",
    "Buffer",
    "ConnectivityException",
    "ExtrapolationException",
    "ForwardExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NoDataForExtrapolationException",
    "StaticTransformListener",
    "TimeoutException",
    "TransformException",
    "TransformListener",
]
