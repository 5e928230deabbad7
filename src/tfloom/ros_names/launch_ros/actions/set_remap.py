"""The action that remaps a name for later nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.set_remap import SetRemap as SetRemap
