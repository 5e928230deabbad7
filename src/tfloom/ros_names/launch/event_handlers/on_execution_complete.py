"""Handler of the end of an action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_execution_complete import OnExecutionComplete as OnExecutionComplete
