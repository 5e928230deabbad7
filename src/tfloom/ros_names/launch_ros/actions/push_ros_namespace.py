"""The action that puts later nodes into a namespace."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.push_ros_namespace import PushROSNamespace as PushROSNamespace
    from tfloom.launch.ros.utilities.namespace_utils import make_namespace_absolute as make_namespace_absolute
    from tfloom.launch.ros.utilities.namespace_utils import prefix_namespace as prefix_namespace
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure as SubstitutionFailure
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.node.values.names import validate_namespace as validate_namespace
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        Parser="tfloom.launch.frontend.parser",
        PushROSNamespace="tfloom.launch.ros.actions.push_ros_namespace",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        SubstitutionFailure="tfloom.launch.substitutions.substitution_failure",
        expose_action="tfloom.launch.frontend.expose",
        make_namespace_absolute="tfloom.launch.ros.utilities.namespace_utils",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        prefix_namespace="tfloom.launch.ros.utilities.namespace_utils",
        validate_namespace="tfloom.node.values.names",
    )
