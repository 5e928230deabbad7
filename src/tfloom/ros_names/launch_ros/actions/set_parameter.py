"""The action that sets a parameter of later nodes."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.set_parameter import SetParameter as SetParameter
