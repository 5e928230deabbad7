"""Warns, when it is loaded, of rclpy's module of this name if the distribution that is followed lacks it."""

from __future__ import annotations

from tfloom.ros_imports.ros_distro import warn_if_removed

# Level 3 is the line that imports the façade, as of `qos_event`.
warn_if_removed("rclpy.topic_endpoint_info", stacklevel=3)
