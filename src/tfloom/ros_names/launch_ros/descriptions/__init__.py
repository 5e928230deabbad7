"""Descriptions of what a node is given."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ComposableNode",
    "Parameter",
    "ParameterFile",
    "ParameterValue",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch_ros.descriptions import composable_node as composable_node
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
    from tfloom.launch.ros.parameter_descriptions import Parameter as Parameter
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.parameter_descriptions import ParameterValue as ParameterValue
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
        Parameter="tfloom.launch.ros.parameter_descriptions",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        ParameterValue="tfloom.launch.ros.parameter_descriptions",
        composable_node="launch_ros.descriptions",
    )
