"""The functions of `ros2component.api`: containers of components, and the components that packages register."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from tfloom.cli.api.answers import TIMEOUT_S, Call, call_services
from tfloom.cli.api.node import NodeName, get_node_names
from tfloom.cli.api.nodes import GraphNode, NodeStrategy
from tfloom.cli.component import (
    LIST,
    LOAD,
    SERVICES,
    UNLOAD,
    add_component_arguments,
    is_container,
    log_level_number,
    parameters_of,
)
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.names import full_name
from tfloom.interfaces.composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from tfloom.workspace.ament import get_resource, get_resources

__all__ = [
    "ComponentInfo",
    "add_component_arguments",
    "container_node_name_completer",
    "find_container_node_names",
    "get_components_in_container",
    "get_components_in_containers",
    "get_package_component_types",
    "get_package_names_with_component_types",
    "get_registered_component_types",
    "load_component_into_container",
    "unload_component_from_container",
]

_RESOURCE_TYPE = "rclcpp_components"


class ComponentInfo(NamedTuple):
    """A component in a container."""

    uid: int
    name: str
    """Its node's full name."""


def get_package_names_with_component_types() -> list[str]:
    """Return the names of the packages that register components."""
    return list(get_resources(_RESOURCE_TYPE))


def get_package_component_types(*, package_name: str | None = None) -> list[str]:
    """Return the types of the components that a package registers, none for a package without any.

    Raises:
        ValueError: the name contains a path separator, or is missing.
    """
    if not package_name:
        raise ValueError("package_name: the name of a package is needed")
    try:
        content, _ = get_resource(_RESOURCE_TYPE, package_name)
    except LookupError:
        return []
    return [line.partition(";")[0] for line in content.splitlines() if line]


def get_registered_component_types() -> list[tuple[str, list[str]]]:
    """Return the packages that register components, each with the types of its components."""
    return [
        (name, get_package_component_types(package_name=name))
        for name in get_package_names_with_component_types()
    ]


def find_container_node_names(*, node: GraphNode, node_names: Iterable[NodeName]) -> list[NodeName]:
    """Return those of some nodes that have the services of a container."""
    served = {(name, type_name) for name, types in _services(node) for type_name in types}
    return [name for name in node_names if is_container(name.full_name, served)]


def _services(node: GraphNode) -> list[tuple[str, list[str]]]:
    services: list[tuple[str, list[str]]] = node.get_service_names_and_types()
    return services


def _service_name(container: str, service: str) -> str:
    return f"{full_name(container)}/{service}"


def container_node_name_completer(prefix: str, parsed_args: Any, **_: Any) -> list[str]:
    """Return the full names of the containers on the graph."""
    with NodeStrategy(parsed_args) as node:
        containers = find_container_node_names(node=node, node_names=get_node_names(node=node))
    return [container.full_name for container in containers]


def get_components_in_container(
    *, node: GraphNode, remote_container_node_name: str
) -> tuple[bool, list[ComponentInfo] | str]:
    """Return True and the components in a container, or False and why it can't be asked."""
    containers = get_components_in_containers(
        node=node, remote_containers_node_names=[remote_container_node_name]
    )
    return containers[remote_container_node_name]


def get_components_in_containers(
    *, node: GraphNode, remote_containers_node_names: Iterable[str]
) -> dict[str, tuple[bool, list[ComponentInfo] | str]]:
    """Return for each container, by its name, True and its components, or False and why it can't be asked."""
    calls = {
        name: Call(ListNodes, _service_name(name, LIST), ListNodes.Request())
        for name in remote_containers_node_names
    }
    return {
        name: (False, str(answer))
        if isinstance(answer, Exception)
        else (True, list(map(ComponentInfo, answer.unique_ids, answer.full_node_names)))
        for name, answer in call_services(node, calls).items()
    }


def load_component_into_container(
    *,
    node: GraphNode,
    remote_container_node_name: str,
    package_name: str,
    plugin_name: str,
    node_name: str | None = None,
    node_namespace: str | None = None,
    log_level: int | str | None = None,
    remap_rules: Sequence[str] | None = None,
    parameters: Sequence[str] | None = None,
    extra_arguments: Sequence[str] | None = None,
) -> tuple[int, str]:
    """Load a component into a container; return its id and its node's full name.

    Args:
        node: What asks.
        remote_container_node_name: Name of the container.
        package_name: Package of the component.
        plugin_name: Type of the component, as `composition::Talker`.
        node_name: Name of the node; by default the component's own.
        node_namespace: Namespace of the node; by default the component's own.
        log_level: Its log level, by number or name.
        remap_rules: Remappings, as `from:=to`.
        parameters: Parameters, as `name:=value`.
        extra_arguments: Arguments of the container for this component, as `name:=value`.

    Raises:
        RuntimeError: the container isn't there, or has rejected it; a parameter is none, or a log level.
    """
    try:
        request = LoadNode.Request(
            package_name=package_name,
            plugin_name=plugin_name,
            node_name=node_name or "",
            node_namespace=node_namespace or "",
            log_level=log_level_number(str(log_level or 0)),
            remap_rules=list(remap_rules or ()),
            parameters=parameters_of(parameters or ()),
            extra_arguments=parameters_of(extra_arguments or ()),
        )
    except (CommandError, ValueError) as error:
        raise RuntimeError(str(error)) from None
    answer = _ask(node, remote_container_node_name, LOAD, request)
    if not answer.success:
        raise RuntimeError(f"Failed to load component: {answer.error_message.capitalize()}")
    return answer.unique_id, answer.full_node_name


def unload_component_from_container(
    *, node: GraphNode, remote_container_node_name: str, component_uids: Iterable[int]
) -> Iterator[tuple[int, bool, str]]:
    """Unload components from a container; yield for each its id, whether that failed, and the reason.

    Raises:
        RuntimeError: the container isn't there, or doesn't respond.
    """
    for uid in component_uids:
        request = UnloadNode.Request(unique_id=uid)
        answer = _ask(node, remote_container_node_name, UNLOAD, request)
        yield uid, not answer.success, answer.error_message


def _ask(node: GraphNode, container: str, service: str, request: Any) -> Any:
    # The container responds to load_node when the component's constructor has returned, however long that takes.
    timeout_s = None if service == LOAD else TIMEOUT_S
    call = Call(SERVICES[service], _service_name(container, service), request)
    answer = call_services(node, {service: call}, timeout_s)[service]
    if isinstance(answer, Exception):
        raise RuntimeError(str(answer)) from answer  # noqa: TRY004  # `answer` is an error
    return answer
