"""tf2_ros's buffer and listener for the nodes of a real rclpy: `from tfloom.drop_in import Buffer, TransformListener`.

Where `rclpy` is tfloom's, these are the classes of `tfloom.tf2_ros`, so that a program runs in both places.

- buffer, transform_listener: tf2_ros for nodes of a real rclpy
- sources: a reader beside the node, or a raw subscription
- errors: also tf2_py's
- real_ros: that ROS's names
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

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
    from tfloom.tf2_ros import transform_listener
    from tfloom.tf2_ros.buffer import Buffer

    class TransformListener(transform_listener.TransformListener):
        """See `tfloom.tf2_ros.transform_listener`; `raw` has no effect, because each reader is tfloom's own."""

        def __init__(self, buffer: Any, node: Any, *, raw: bool | None = None, **options: Any) -> None:
            super().__init__(buffer, node, **options)

    class StaticTransformListener(transform_listener.StaticTransformListener):
        """See `TransformListener`."""

        def __init__(self, buffer: Any, node: Any, *, raw: bool | None = None, **options: Any) -> None:
            super().__init__(buffer, node, **options)


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
