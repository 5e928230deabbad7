"""Draws the tree of frames."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("tf2_tools")

from tfloom.tf2_tools.view_frames import generate_dot as generate_dot
from tfloom.tf2_tools.view_frames import main as main

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.interfaces.tf2_msgs.srv import FrameGraph as FrameGraph
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        FrameGraph="tfloom.interfaces.tf2_msgs.srv",
    )
