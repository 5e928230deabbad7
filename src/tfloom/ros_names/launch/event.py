"""The base class of events."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event import Event as Event
