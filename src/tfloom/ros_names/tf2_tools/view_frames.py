"""Draws the tree of frames."""

from tfloom.ros_guard import claim

claim("tf2_tools")

from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
from tfloom.tf2_tools.view_frames import generate_dot as generate_dot
from tfloom.tf2_tools.view_frames import main as main
