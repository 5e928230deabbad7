"""The events executor, which runs callbacks in the order of their events."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.events_executor import EventsExecutor as EventsExecutor
