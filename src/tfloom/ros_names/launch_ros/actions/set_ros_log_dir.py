"""The action that sets the folder of later nodes' logs."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.set_ros_log_dir import SetROSLogDir as SetROSLogDir
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.node.log.logging import get_logging_directory as get_logging_directory
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        Parser="tfloom.launch.frontend.parser",
        SetROSLogDir="tfloom.launch.ros.actions.set_ros_log_dir",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        Substitution="tfloom.launch.substitution",
        expose_action="tfloom.launch.frontend.expose",
        get_logging_directory="tfloom.node.log.logging",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
