"""Types of remappings: as launch files give them, and normalized."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.ros.remap_rule_type import RemapRule as RemapRule
    from tfloom.launch.ros.remap_rule_type import RemapRules as RemapRules
    from tfloom.launch.ros.remap_rule_type import SomeRemapRule as SomeRemapRule
    from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        RemapRule="tfloom.launch.ros.remap_rule_type",
        RemapRules="tfloom.launch.ros.remap_rule_type",
        SomeRemapRule="tfloom.launch.ros.remap_rule_type",
        SomeRemapRules="tfloom.launch.ros.remap_rule_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
    )
