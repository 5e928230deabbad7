"""A condition that holds where a text is true."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
