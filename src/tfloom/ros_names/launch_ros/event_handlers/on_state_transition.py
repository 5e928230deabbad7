"""The handler of transitions of lifecycle nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.event_handlers.on_state_transition import OnStateTransition as OnStateTransition
