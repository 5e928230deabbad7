"""Markers that viewers show and users move."""

from tfloom.ros_guard import claim

claim("interactive_markers")

import interactive_markers.interactive_marker_server
import interactive_markers.menu_handler
from tfloom_sensing.interactive_marker_server import InteractiveMarkerServer
from tfloom_sensing.menu_handler import MenuHandler

__all__ = ["InteractiveMarkerServer", "MenuHandler"]
