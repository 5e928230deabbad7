"""Markers that viewers show and users move."""

from tfloom.ros_guard import claim

claim("interactive_markers")

from tfloom.sensing.interactive_marker_server import InteractiveMarkerServer
from tfloom.sensing.menu_handler import MenuHandler

__all__ = ["InteractiveMarkerServer", "MenuHandler"]
