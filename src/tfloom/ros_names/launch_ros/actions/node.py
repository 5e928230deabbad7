"""The action that starts a node."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.node import Node as Node
from tfloom.launch.ros.actions.node_extensions import NodeActionExtension as NodeActionExtension
from tfloom.launch.ros.actions.node_extensions import get_extensions as get_extensions
from tfloom.launch.ros.actions.node_extensions import instantiate_extension as instantiate_extension

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
    from tfloom.launch.ros.parameter_descriptions import ParameterFile as ParameterFile
    from tfloom.launch.ros.remap_rule_type import SomeRemapRules as SomeRemapRules
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ExecuteProcess="tfloom.launch.actions.execute_process",
        ParameterFile="tfloom.launch.ros.parameter_descriptions",
        SomeRemapRules="tfloom.launch.ros.remap_rule_type",
    )
