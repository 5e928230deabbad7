"""Warns, when it is loaded, that rclpy's module of this name is deprecated; what it had is in `event_handler`."""

from __future__ import annotations

import warnings

# Level 3 is the line that imports the façade, because the warning concerns that line.
warnings.warn("importing 'qos_event' is deprecated; import 'event_handler' instead", stacklevel=3)
