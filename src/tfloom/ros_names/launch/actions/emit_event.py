"""Emit an event."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
