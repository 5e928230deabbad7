"""The action that would load nodes in C++ into a container."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.composable_node_container import (
        ComposableNodeContainer as ComposableNodeContainer,
    )
    from tfloom.launch.ros.actions.load_composable_nodes import LoadComposableNodes as LoadComposableNodes
    from tfloom.launch.ros.actions.load_composable_nodes import (
        get_composable_node_load_request as get_composable_node_load_request,
    )
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.ros_adapters import get_ros_node as get_ros_node
    from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters as evaluate_parameters
    from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
    from tfloom.launch.ros.utilities.normalize_parameters import (
        normalize_parameter_dict as normalize_parameter_dict,
    )
    from tfloom.launch.ros.utilities.to_parameters_list import to_parameters_list as to_parameters_list
    from tfloom.launch.ros.utilities.track_node_names import add_node_name as add_node_name
    from tfloom.launch.ros.utilities.track_node_names import get_node_name_count as get_node_name_count
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.some_substitutions_type import (
        SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple,
    )
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
        ComposableNodeContainer="tfloom.launch.ros.actions.composable_node_container",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        LoadComposableNodes="tfloom.launch.ros.actions.load_composable_nodes",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        Parser="tfloom.launch.frontend.parser",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        SomeSubstitutionsType_types_tuple="tfloom.launch.some_substitutions_type",
        add_node_name="tfloom.launch.ros.utilities.track_node_names",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        evaluate_parameters="tfloom.launch.ros.utilities.evaluate_parameters",
        expose_action="tfloom.launch.frontend.expose",
        get_composable_node_load_request="tfloom.launch.ros.actions.load_composable_nodes",
        get_node_name_count="tfloom.launch.ros.utilities.track_node_names",
        get_ros_node="tfloom.launch.ros.ros_adapters",
        is_a_subclass="tfloom.launch.utilities.class_tools",
        make_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        normalize_parameter_dict="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        prefix_namespace="tfloom.launch.ros.utilities.namespace_utils",
        to_parameters_list="tfloom.launch.ros.utilities.to_parameters_list",
    )
