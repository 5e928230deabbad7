"""Queries for the actions on the graph."""

from typing import TYPE_CHECKING

from tfloom.node.action.graph import *

if TYPE_CHECKING:
    from tfloom.node.node import Node as Node
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Node="tfloom.node.node",
    )
