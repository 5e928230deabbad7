"""Remappings in every form as tuples of substitutions."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.remap_rule_type import RemapRule as RemapRule
    from tfloom.launch.ros.remap_rule_type import RemapRules as RemapRules
    from tfloom.launch.ros.remap_rule_type import SomeRemapRule as SomeRemapRule
    from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
    from tfloom.launch.ros.utilities.normalize_remap_rule import normalize_remap_rule as normalize_remap_rule
    from tfloom.launch.ros.utilities.normalize_remap_rule import (
        normalize_remap_rules as normalize_remap_rules,
    )
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        RemapRule="tfloom.launch.ros.remap_rule_type",
        RemapRules="tfloom.launch.ros.remap_rule_type",
        SomeRemapRule="tfloom.launch.ros.remap_rule_type",
        SomeRemapRules="tfloom.launch.ros.remap_rule_type",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        normalize_remap_rule="tfloom.launch.ros.utilities.normalize_remap_rule",
        normalize_remap_rules="tfloom.launch.ros.utilities.normalize_remap_rule",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
    )
