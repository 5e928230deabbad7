"""The action that gives later nodes the parameters of a file."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.set_parameters_from_file import SetParametersFromFile as SetParametersFromFile
