"""Queries for the actions on the graph."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.action.graph import get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node
from tfloom.node.action.graph import get_action_names_and_types as get_action_names_and_types
from tfloom.node.action.graph import get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.node import Node as Node
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Node="tfloom.node.node",
    )
