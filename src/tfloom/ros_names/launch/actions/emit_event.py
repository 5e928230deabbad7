"""Emit an event."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
from tfloom.launch.event import Event as Event
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
