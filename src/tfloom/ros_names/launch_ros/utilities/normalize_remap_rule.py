"""Remappings in every form as tuples of substitutions."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.normalize_remap_rule import normalize_remap_rule as normalize_remap_rule
from tfloom.launch.ros.utilities.normalize_remap_rule import normalize_remap_rules as normalize_remap_rules
