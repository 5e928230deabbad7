"""Nodes in launch files."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("launch_ros")

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros import actions as actions
    from launch_ros import descriptions as descriptions
    from launch_ros import event_handlers as event_handlers
    from launch_ros import events as events
    from launch_ros import parameter_descriptions as parameter_descriptions
    from launch_ros import parameters_type as parameters_type
    from launch_ros import remap_rule_type as remap_rule_type
    from launch_ros import ros_adapters as ros_adapters
    from launch_ros import substitutions as substitutions
    from launch_ros import utilities as utilities
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        actions="launch_ros",
        descriptions="launch_ros",
        event_handlers="launch_ros",
        events="launch_ros",
        parameter_descriptions="launch_ros",
        parameters_type="launch_ros",
        remap_rule_type="launch_ros",
        ros_adapters="launch_ros",
        substitutions="launch_ros",
        utilities="launch_ros",
    )
