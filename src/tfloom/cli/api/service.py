"""The functions of `ros2service.api`: services on the graph, and their classes."""

from __future__ import annotations

from typing import Any

from tfloom.cli.api.answers import argument_key
from tfloom.cli.api.nodes import GraphNode, NodeStrategy
from tfloom.cli.shared.names import full_name
from tfloom.node.values.names import topic_or_service_is_hidden
from tfloom.rosidl.runtime import get_service
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.workspace.interfaces import known_interfaces

__all__ = [
    "ServiceNameCompleter",
    "ServicePrototypeCompleter",
    "ServiceTypeCompleter",
    "get_service_class",
    "get_service_names",
    "get_service_names_and_types",
    "service_type_completer",
]


def get_service_names_and_types(
    *, node: GraphNode, include_hidden_services: bool = False
) -> list[tuple[str, list[str]]]:
    """Return the services on the graph, with their types."""
    services: list[tuple[str, list[str]]] = node.get_service_names_and_types()
    return [
        (name, types)
        for name, types in services
        if include_hidden_services or not topic_or_service_is_hidden(name)
    ]


def get_service_names(*, node: GraphNode, include_hidden_services: bool = False) -> list[str]:
    """Return the names of the services on the graph."""
    services = get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)
    return [name for name, _ in services]


def get_service_class(node: GraphNode, service: str, include_hidden_services: bool) -> Any:
    """Return the class of a service on the graph; None if there is no such service.

    Raises:
        RuntimeError: the service has several types, or one of which there is no class.
    """
    services = dict(get_service_names_and_types(node=node, include_hidden_services=include_hidden_services))
    types = services.get(full_name(service), [])
    if not types:
        return None
    if len(types) > 1:
        raise RuntimeError(
            f"Cannot echo service '{service}', as it contains more than one type: [{', '.join(types)}]"
        )
    try:
        return get_service(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The service type '{types[0]}' is invalid") from None


def service_type_completer(**_: Any) -> list[str]:
    """Return all service types."""
    return known_interfaces("srv")


class ServiceNameCompleter:
    """Lists the services on the graph.

    Args:
        include_hidden_services_key: The argument that says whether hidden ones are listed.
    """

    def __init__(self, *, include_hidden_services_key: str | None = None) -> None:
        self.include_hidden_services_key = argument_key(
            include_hidden_services_key, "include_hidden_services"
        )

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with NodeStrategy(parsed_args) as node:
            hidden = getattr(parsed_args, self.include_hidden_services_key, False)
            return get_service_names(node=node, include_hidden_services=hidden)


class ServiceTypeCompleter:
    """Lists the types of a service on the graph; without one, all service types.

    Args:
        service_name_key: The argument with the service's name.
    """

    def __init__(self, *, service_name_key: str | None = None) -> None:
        self.service_name_key = argument_key(service_name_key, "service_name")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return the words that may follow on the command line."""
        with NodeStrategy(parsed_args) as node:
            services = dict(get_service_names_and_types(node=node, include_hidden_services=True))
        return (
            services.get(full_name(getattr(parsed_args, self.service_name_key))) or service_type_completer()
        )


class ServicePrototypeCompleter:
    """Lists the one value that a request starts as, as YAML.

    Args:
        service_type_key: The argument with the service's type.
    """

    def __init__(self, *, service_type_key: str | None = None) -> None:
        self.service_type_key = argument_key(service_type_key, "service_type")

    def __call__(self, prefix: str, parsed_args: Any, **_: Any) -> list[str]:
        """Return a request with its defaults."""
        return [message_to_yaml(get_service(getattr(parsed_args, self.service_type_key)).Request())]
