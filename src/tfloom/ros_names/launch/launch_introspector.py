"""The text of a launch description's entities."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
from tfloom.launch.actions.log import LogInfo as LogInfo
from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.launch_description import LaunchDescription as LaunchDescription
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.launch_introspector import LaunchIntrospector as LaunchIntrospector
from tfloom.launch.launch_introspector import format_action as format_action
from tfloom.launch.launch_introspector import format_entities as format_entities
from tfloom.launch.launch_introspector import format_event_handler as format_event_handler
from tfloom.launch.launch_introspector import format_substitutions as format_substitutions
from tfloom.launch.launch_introspector import indent as indent
from tfloom.launch.launch_introspector import tree_like_indent as tree_like_indent
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from tfloom.launch.utilities.class_tools import is_a as is_a
from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
    normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
)
