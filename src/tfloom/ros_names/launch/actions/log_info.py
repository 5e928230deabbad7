"""Log a message."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.log import LogInfo as LogInfo
