"""Unregister an event handler."""

from tfloom.launch.action import Action as Action
from tfloom.launch.actions.unregister_event_handler import UnregisterEventHandler as UnregisterEventHandler
from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.launch_context import LaunchContext as LaunchContext
