"""The action that gives later nodes the parameters of a file."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.set_parameters_from_file import (
        SetParametersFromFile as SetParametersFromFile,
    )
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        Parser="tfloom.launch.frontend.parser",
        SetParametersFromFile="tfloom.launch.ros.actions.set_parameters_from_file",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        expose_action="tfloom.launch.frontend.expose",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
