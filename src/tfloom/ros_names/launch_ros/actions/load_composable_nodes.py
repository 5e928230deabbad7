"""The action that would load nodes in C++ into a container."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.load_composable_nodes import LoadComposableNodes as LoadComposableNodes
from tfloom.launch.ros.actions.load_composable_nodes import get_composable_node_load_request as get_composable_node_load_request
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.ros.actions.composable_node_container import ComposableNodeContainer as ComposableNodeContainer
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
        ComposableNodeContainer="tfloom.launch.ros.actions.composable_node_container",
    )
