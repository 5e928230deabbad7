"""The base class of the events that do something to a process."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
