"""The listeners for nodes of tfloom's own rclpy: those of `tfloom.tf2_ros`, with the argument of the drop-in ones."""

from __future__ import annotations

from typing import Any

from tfloom.tf2_ros import transform_listener

__all__ = ["StaticTransformListener", "TransformListener"]


class TransformListener(transform_listener.TransformListener):
    """See `tfloom.tf2_ros.transform_listener`; `raw` has no effect, because each reader is tfloom's own."""

    def __init__(self, buffer: Any, node: Any, *, raw: bool | None = None, **options: Any) -> None:
        super().__init__(buffer, node, **options)


class StaticTransformListener(transform_listener.StaticTransformListener):
    """See `TransformListener`."""

    def __init__(self, buffer: Any, node: Any, *, raw: bool | None = None, **options: Any) -> None:
        super().__init__(buffer, node, **options)
