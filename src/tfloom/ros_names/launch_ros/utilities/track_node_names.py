"""The names of the nodes that a launch has started."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.utilities.track_node_names import add_node_name as add_node_name
    from tfloom.launch.ros.utilities.track_node_names import get_node_name_count as get_node_name_count
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        LaunchContext="tfloom.launch.launch_context",
        add_node_name="tfloom.launch.ros.utilities.track_node_names",
        get_node_name_count="tfloom.launch.ros.utilities.track_node_names",
    )
