"""Execute a command."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
