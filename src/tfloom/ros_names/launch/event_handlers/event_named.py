"""A matcher by an event's name."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.event_named import event_named as event_named
