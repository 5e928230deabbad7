"""Group actions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.group_action import GroupAction as GroupAction
