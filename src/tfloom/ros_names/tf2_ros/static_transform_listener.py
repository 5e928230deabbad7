"""Fill a buffer from /tf_static."""

from tfloom.tf2_ros.transform_listener import StaticTransformListener

__all__ = ["StaticTransformListener"]
