"""Log a message."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.log import Log as Log
from tfloom.launch.actions.log import LogDebug as LogDebug
from tfloom.launch.actions.log import LogError as LogError
from tfloom.launch.actions.log import LogInfo as LogInfo
from tfloom.launch.actions.log import LogWarning as LogWarning
