"""Nodes in C++ that a container loads: described only, because a container is a C++ program."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.condition import Condition as Condition
    from tfloom.launch.conditions.if_condition import IfCondition as IfCondition
    from tfloom.launch.conditions.unless_condition import UnlessCondition as UnlessCondition
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
    from tfloom.launch.ros.parameters_type import Parameters as Parameters
    from tfloom.launch.ros.parameters_type import SomeParameters as SomeParameters
    from tfloom.launch.ros.remap_rule_type import RemapRules as RemapRules
    from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
    from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters as normalize_parameters
    from tfloom.launch.ros.utilities.normalize_remap_rule import (
        normalize_remap_rules as normalize_remap_rules,
    )
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
        Condition="tfloom.launch.condition",
        Entity="tfloom.launch.frontend.entity",
        IfCondition="tfloom.launch.conditions.if_condition",
        Parameters="tfloom.launch.ros.parameters_type",
        Parser="tfloom.launch.frontend.parser",
        RemapRules="tfloom.launch.ros.remap_rule_type",
        SomeParameters="tfloom.launch.ros.parameters_type",
        SomeRemapRules="tfloom.launch.ros.remap_rule_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        UnlessCondition="tfloom.launch.conditions.unless_condition",
        normalize_parameters="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_remap_rules="tfloom.launch.ros.utilities.normalize_remap_rule",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
    )
