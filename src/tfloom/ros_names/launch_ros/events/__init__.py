"""Events of nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "matches_node_name",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.events import lifecycle as lifecycle
    from launch_ros.events import matchers as matchers
    from tfloom.launch.ros.events.matchers import matches_node_name as matches_node_name
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        lifecycle="launch_ros.events",
        matchers="launch_ros.events",
        matches_node_name="tfloom.launch.ros.events.matchers",
    )
