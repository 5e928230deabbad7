"""Warns, when it is loaded, that rclpy's module of this name is deprecated; what it had is in `event_handler`."""

from __future__ import annotations

import warnings

from tfloom.ros_imports.ros_distro import removal

# Level 3 is the line that imports the façade, because the warning concerns that line.
_GONE = removal("rclpy.qos_event")
warnings.warn(
    _GONE or "importing 'qos_event' is deprecated; import 'event_handler' instead",
    DeprecationWarning if _GONE else UserWarning,
    stacklevel=3,
)
