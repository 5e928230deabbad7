"""The event of a lifecycle node's transition."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
