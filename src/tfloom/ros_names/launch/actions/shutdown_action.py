"""End the launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.shutdown_action import Shutdown as Shutdown
from tfloom.launch.events.shutdown import Shutdown as ShutdownEvent

__all__ = [
    "Shutdown",
    "ShutdownEvent",
]
