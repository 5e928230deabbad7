"""The action that starts a node."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch_ros.utilities import plugin_support as plugin_support
    from tfloom.launch.action import Action as Action
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.frontend.type_utils import (
        get_data_type_from_identifier as get_data_type_from_identifier,
    )
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.node import Node as Node
    from tfloom.launch.ros.actions.node_extensions import NodeActionExtension as NodeActionExtension
    from tfloom.launch.ros.actions.node_extensions import get_extensions as get_extensions
    from tfloom.launch.ros.actions.node_extensions import instantiate_extension as instantiate_extension
    from tfloom.launch.ros.parameter_descriptions import Parameter as Parameter
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameters_type import SomeParameters as SomeParameters
    from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
    from tfloom.launch.ros.substitutions.executable_in_package import (
        ExecutableInPackage as ExecutableInPackage,
    )
    from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters as evaluate_parameters
    from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
    from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters as normalize_parameters
    from tfloom.launch.ros.utilities.normalize_remap_rule import (
        normalize_remap_rules as normalize_remap_rules,
    )
    from tfloom.launch.ros.utilities.track_node_names import add_node_name as add_node_name
    from tfloom.launch.ros.utilities.track_node_names import get_node_name_count as get_node_name_count
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitutions.local_substitution import LocalSubstitution as LocalSubstitution
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.node.values.names import validate_namespace as validate_namespace
    from tfloom.node.values.names import validate_node_name as validate_node_name
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        ExecutableInPackage="tfloom.launch.ros.substitutions.executable_in_package",
        ExecuteProcess="tfloom.launch.actions.execute_process",
        LaunchContext="tfloom.launch.launch_context",
        LocalSubstitution="tfloom.launch.substitutions.local_substitution",
        Node="tfloom.launch.ros.actions.node",
        NodeActionExtension="tfloom.launch.ros.actions.node_extensions",
        Parameter="tfloom.launch.ros.parameter_descriptions",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        Parser="tfloom.launch.frontend.parser",
        SomeParameters="tfloom.launch.ros.parameters_type",
        SomeRemapRules="tfloom.launch.ros.remap_rule_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        add_node_name="tfloom.launch.ros.utilities.track_node_names",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        evaluate_parameters="tfloom.launch.ros.utilities.evaluate_parameters",
        expose_action="tfloom.launch.frontend.expose",
        get_data_type_from_identifier="tfloom.launch.frontend.type_utils",
        get_extensions="tfloom.launch.ros.actions.node_extensions",
        get_node_name_count="tfloom.launch.ros.utilities.track_node_names",
        instantiate_extension="tfloom.launch.ros.actions.node_extensions",
        make_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        normalize_parameters="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_remap_rules="tfloom.launch.ros.utilities.normalize_remap_rule",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        plugin_support="launch_ros.utilities",
        prefix_namespace="tfloom.launch.ros.utilities.namespace_utils",
        validate_namespace="tfloom.node.values.names",
        validate_node_name="tfloom.node.values.names",
    )
