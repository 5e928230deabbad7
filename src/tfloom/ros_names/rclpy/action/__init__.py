"""Actions: goals that take time, with feedback on the way and a result at the end."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "ActionClient",
    "ActionServer",
    "CancelResponse",
    "GoalResponse",
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rclpy.action import client as client
    from rclpy.action import graph as graph
    from rclpy.action import server as server
    from tfloom.node.action.client import ActionClient as ActionClient
    from tfloom.node.action.graph import get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node
    from tfloom.node.action.graph import get_action_names_and_types as get_action_names_and_types
    from tfloom.node.action.graph import get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node
    from tfloom.node.action.server import ActionServer as ActionServer
    from tfloom.node.action.server import CancelResponse as CancelResponse
    from tfloom.node.action.server import GoalResponse as GoalResponse
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ActionClient="tfloom.node.action.client",
        ActionServer="tfloom.node.action.server",
        CancelResponse="tfloom.node.action.server",
        GoalResponse="tfloom.node.action.server",
        client="rclpy.action",
        get_action_client_names_and_types_by_node="tfloom.node.action.graph",
        get_action_names_and_types="tfloom.node.action.graph",
        get_action_server_names_and_types_by_node="tfloom.node.action.graph",
        graph="rclpy.action",
        server="rclpy.action",
    )
