"""Unregister an event handler."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.unregister_event_handler import UnregisterEventHandler as UnregisterEventHandler
