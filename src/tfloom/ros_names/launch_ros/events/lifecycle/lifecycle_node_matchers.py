"""The matcher of lifecycle nodes, by its former place."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.events.lifecycle.lifecycle_node_matchers import (
        matches_node_name as matches_node_name,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        matches_node_name="tfloom.launch.ros.events.lifecycle.lifecycle_node_matchers",
    )
