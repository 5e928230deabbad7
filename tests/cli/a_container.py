"""A node with the services of a container, whose components are names alone; Nothing can't be loaded."""

from __future__ import annotations

import rclpy
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rclpy.parameter import parameter_value_to_python
from serving import serve

components: dict[int, str] = {}


def load(request: LoadNode.Request, response: LoadNode.Response) -> LoadNode.Response:
    if request.plugin_name == "Nothing":
        response.error_message = "no such plugin in " + request.package_name
        return response
    response.success = True
    response.unique_id = 2**63 + len(components)
    name = request.node_name or request.plugin_name.rpartition("::")[2].lower()
    response.full_node_name = f"{request.node_namespace}/{name}"
    components[response.unique_id] = response.full_node_name
    given = {parameter.name: parameter_value_to_python(parameter.value) for parameter in request.parameters}
    extra = {argument.name: parameter_value_to_python(argument.value) for argument in request.extra_arguments}
    print("loaded", request.log_level, list(request.remap_rules), given, extra, flush=True)
    return response


def unload(request: UnloadNode.Request, response: UnloadNode.Response) -> UnloadNode.Response:
    response.success = components.pop(request.unique_id, None) is not None
    if not response.success:
        response.error_message = "no node found with that id"
    return response


def list_nodes(_: ListNodes.Request, response: ListNodes.Response) -> ListNodes.Response:
    response.unique_ids = list(components)
    response.full_node_names = list(components.values())
    return response


rclpy.init()
node = rclpy.create_node("a_container")
node.create_service(LoadNode, "~/_container/load_node", load)
node.create_service(UnloadNode, "~/_container/unload_node", unload)
node.create_service(ListNodes, "~/_container/list_nodes", list_nodes)
serve(node)
