"""Normalized parameters with their substitutions performed."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameters_type import EvaluatedParameters as EvaluatedParameters
    from tfloom.launch.ros.parameters_type import EvaluatedParameterValue as EvaluatedParameterValue
    from tfloom.launch.ros.parameters_type import ParameterDescription as ParameterDescription
    from tfloom.launch.ros.parameters_type import Parameters as Parameters
    from tfloom.launch.ros.parameters_type import ParametersDict as ParametersDict
    from tfloom.launch.ros.parameters_type import ParameterValueDescription as ParameterValueDescription
    from tfloom.launch.ros.utilities.evaluate_parameters import (
        evaluate_parameter_dict as evaluate_parameter_dict,
    )
    from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters as evaluate_parameters
    from tfloom.launch.substitution import Substitution as Substitution
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EvaluatedParameterValue="tfloom.launch.ros.parameters_type",
        EvaluatedParameters="tfloom.launch.ros.parameters_type",
        LaunchContext="tfloom.launch.launch_context",
        ParameterDescription="tfloom.launch.ros.parameters_type",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        ParameterValueDescription="tfloom.launch.ros.parameters_type",
        Parameters="tfloom.launch.ros.parameters_type",
        ParametersDict="tfloom.launch.ros.parameters_type",
        Substitution="tfloom.launch.substitution",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        evaluate_parameter_dict="tfloom.launch.ros.utilities.evaluate_parameters",
        evaluate_parameters="tfloom.launch.ros.utilities.evaluate_parameters",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
    )
