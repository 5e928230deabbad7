"""The event that requests a transition of lifecycle nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.events.lifecycle.change_state import ChangeState as ChangeState
