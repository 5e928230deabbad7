"""Actions: goals that take time, with feedback on the way and a result at the end."""

from typing import TYPE_CHECKING

from tfloom.node.action.client import ActionClient as ActionClient
from tfloom.node.action.graph import *
from tfloom.node.action.server import ActionServer as ActionServer
from tfloom.node.action.server import CancelResponse as CancelResponse
from tfloom.node.action.server import GoalResponse as GoalResponse

if TYPE_CHECKING:
    from rclpy.action import client as client
    from rclpy.action import graph as graph
    from rclpy.action import server as server
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("rclpy.action")
