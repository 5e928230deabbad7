"""Register an event handler."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.register_event_handler import RegisterEventHandler as RegisterEventHandler
