"""The end of an action."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.execution_complete import ExecutionComplete as ExecutionComplete
