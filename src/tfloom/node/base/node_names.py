"""The name of a node, and the full names that its topics and services have."""

from __future__ import annotations

from tfloom.node.context.arguments import Arguments
from tfloom.node.values.names import (
    expand_topic_name,
    expansion_error,
    full_name_error,
    name_error,
    validate_namespace,
    validate_node_name,
)
from tfloom.rmw.base import NodeName

__all__ = ["NodeNames"]


class NodeNames:
    """A node's name after remapping, and the remapping of the names that the node uses.

    Args:
        node_name: The node's name before remapping.
        namespace: Its namespace, with or without the first slash.
        arguments: ROS arguments that apply to the node.

    Raises:
        InvalidNodeNameException: the name isn't valid.
        InvalidNamespaceException: the namespace isn't valid.
    """

    def __init__(self, node_name: str, namespace: str, arguments: Arguments) -> None:
        validate_node_name(node_name)
        if isinstance(namespace, str) and not namespace.startswith("/"):
            namespace = f"/{namespace}"
        namespace = arguments.namespace(node_name, namespace)
        validate_namespace(namespace)
        self._arguments = arguments
        self.node = NodeName(namespace, arguments.node_name(node_name))
        """Name and namespace of the node."""

    def resolved(self, name: str, *, only_expand: bool, is_service: bool) -> str | Exception:
        """Return the full name of a topic or service: expanded, checked, and remapped unless `only_expand`.

        The error of a name that isn't valid, before or after expansion, is returned, for callers whose tracebacks shall
        be short.
        """
        node = self.node
        error = name_error(name, is_service=is_service) or expansion_error(name)
        if error is not None:
            return error
        full_name = expand_topic_name(name, node.name, node.namespace)
        if (error := full_name_error(full_name, is_service=is_service)) is not None:
            return error
        if only_expand:
            return full_name
        remapped = self._arguments.remap(full_name, node.name, node.namespace, is_service=is_service)
        if remapped is None:
            return full_name
        return full_name_error(remapped, is_service=is_service) or remapped
