"""Evaluated parameters as the messages of a node's parameters."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.launch_context import LaunchContext as LaunchContext
    from tfloom.launch.ros.parameters_type import EvaluatedParameters as EvaluatedParameters
    from tfloom.launch.ros.utilities.evaluate_parameters import (
        evaluate_parameter_dict as evaluate_parameter_dict,
    )
    from tfloom.launch.ros.utilities.normalize_parameters import (
        normalize_parameter_dict as normalize_parameter_dict,
    )
    from tfloom.launch.ros.utilities.to_parameters_list import to_parameters_list as to_parameters_list
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        EvaluatedParameters="tfloom.launch.ros.parameters_type",
        LaunchContext="tfloom.launch.launch_context",
        evaluate_parameter_dict="tfloom.launch.ros.utilities.evaluate_parameters",
        normalize_parameter_dict="tfloom.launch.ros.utilities.normalize_parameters",
        to_parameters_list="tfloom.launch.ros.utilities.to_parameters_list",
    )
