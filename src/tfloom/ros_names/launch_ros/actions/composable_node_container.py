"""The action that would start a container of nodes in C++."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.actions.composable_node_container import ComposableNodeContainer as ComposableNodeContainer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.ros.descriptions.composable_node import ComposableNode as ComposableNode
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ComposableNode="tfloom.launch.ros.descriptions.composable_node",
    )
