"""The action that sets a parameter of later nodes."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
    from tfloom.launch.frontend.entity import Entity as Entity
    from tfloom.launch.frontend.expose import expose_action as expose_action
    from tfloom.launch.frontend.parser import Parser as Parser
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.actions.set_parameter import SetParameter as SetParameter
    from tfloom.launch.ros.parameters_type import ParameterName as ParameterName
    from tfloom.launch.ros.parameters_type import ParameterValue as ParameterValue
    from tfloom.launch.ros.parameters_type import SomeParameterValue as SomeParameterValue
    from tfloom.launch.ros.utilities.evaluate_parameters import (
        evaluate_parameter_dict as evaluate_parameter_dict,
    )
    from tfloom.launch.ros.utilities.normalize_parameters import (
        normalize_parameter_dict as normalize_parameter_dict,
    )
    from tfloom.launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import (
        normalize_to_list_of_substitutions as normalize_to_list_of_substitutions,
    )
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
        Entity="tfloom.launch.frontend.entity",
        LaunchContext="tfloom.launch.launch_context",
        ParameterName="tfloom.launch.ros.parameters_type",
        ParameterValue="tfloom.launch.ros.parameters_type",
        Parser="tfloom.launch.frontend.parser",
        SetParameter="tfloom.launch.ros.actions.set_parameter",
        SomeParameterValue="tfloom.launch.ros.parameters_type",
        SomeSubstitutionsType="tfloom.launch.some_substitutions_type",
        evaluate_parameter_dict="tfloom.launch.ros.utilities.evaluate_parameters",
        expose_action="tfloom.launch.frontend.expose",
        normalize_parameter_dict="tfloom.launch.ros.utilities.normalize_parameters",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
    )
