"""The end of a timer's period."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.timer_event import TimerEvent as TimerEvent
