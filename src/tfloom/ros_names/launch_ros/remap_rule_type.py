"""Types of remappings: as launch files give them, and normalized."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.remap_rule_type import RemapRule as RemapRule
from tfloom.launch.ros.remap_rule_type import RemapRules as RemapRules
from tfloom.launch.ros.remap_rule_type import SomeRemapRule as SomeRemapRule
from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
