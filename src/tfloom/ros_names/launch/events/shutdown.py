"""The end of a launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.shutdown import Shutdown as Shutdown
