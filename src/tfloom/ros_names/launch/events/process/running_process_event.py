"""The base class of the events that report on a process."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
