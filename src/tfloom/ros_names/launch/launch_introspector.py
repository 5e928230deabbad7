"""The text of a launch description's entities."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_introspector import LaunchIntrospector as LaunchIntrospector
from tfloom.launch.launch_introspector import format_action as format_action
from tfloom.launch.launch_introspector import format_entities as format_entities
from tfloom.launch.launch_introspector import format_event_handler as format_event_handler
from tfloom.launch.launch_introspector import format_substitutions as format_substitutions
from tfloom.launch.launch_introspector import indent as indent
from tfloom.launch.launch_introspector import tree_like_indent as tree_like_indent

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecuteProcess="tfloom.launch.actions.execute_process",
    )
