"""The base classes of event handlers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
from tfloom.launch.event_handler import EventHandler as EventHandler
