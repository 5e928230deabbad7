"""Nodes in C++ that a container loads."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, ClassVar

from tfloom.launch.core.base_classes import Condition, SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.launch.ros.parameters_type import Parameters, SomeParameters
from tfloom.launch.ros.utilities.names import RemapRules, SomeRemapRules, normalize_remap_rules
from tfloom.launch.ros.utilities.normalize_parameters import normalize_parameters
from tfloom.launch.ros.utilities.parse_node_tags import parse_parameters, parse_remappings
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions

__all__ = ["ComposableNode", "parse_composable_nodes"]


class ComposableNode(HasPrivateNames):
    """A node that a container would load.

    Args:
        package: Package of the plug-in.
        plugin: Name of the plug-in.
        name: Name of the node.
        namespace: Namespace of the node.
        parameters: Its parameters; see Node.
        remappings: Its remappings; see Node.
        extra_arguments: Arguments of the container for this node.
        condition: Decides whether the node is loaded.
    """

    _other_names: ClassVar = {
        "node_plugin": "_plugin",
        "node_name": "_name",
        "node_namespace": "_namespace",
    }

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        extra_arguments: SomeParameters | None = None,
        condition: Condition | None = None,
    ) -> None:
        self._package = normalize_to_list_of_substitutions(package)
        self._plugin = normalize_to_list_of_substitutions(plugin)
        self._name = None if name is None else normalize_to_list_of_substitutions(name)
        self._namespace = None if namespace is None else normalize_to_list_of_substitutions(namespace)
        self._parameters = None if parameters is None else normalize_parameters(parameters)
        self._remappings = None if remappings is None else list(normalize_remap_rules(remappings))
        self._extra_arguments = None if extra_arguments is None else normalize_parameters(extra_arguments)
        self._condition = condition

    @classmethod
    def parse(cls, parser: ParsesActions, entity: Entity) -> tuple[type[ComposableNode], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        kwargs: dict[str, Any] = {
            "package": parser.parse_substitution(entity.get_attr("pkg")),
            "plugin": parser.parse_substitution(entity.get_attr("plugin")),
        }
        if (name := entity.get_attr("name", optional=True)) is not None:
            kwargs["name"] = parser.parse_substitution(name)
        if (namespace := entity.get_attr("namespace", optional=True)) is not None:
            kwargs["namespace"] = parser.parse_substitution(namespace)
        if (condition := parser.parse_condition(entity)) is not None:
            kwargs["condition"] = condition
        if (parameters := parse_parameters(entity, parser)) is not None:
            kwargs["parameters"] = parameters
        if (remappings := parse_remappings(entity, parser)) is not None:
            kwargs["remappings"] = remappings
        if (extra := parse_parameters(entity, parser, "extra_arg")) is not None:
            kwargs["extra_arguments"] = extra
        entity.assert_entity_completely_parsed()
        return cls, kwargs

    @property
    def package(self) -> list[Substitution]:
        """Package of the plug-in."""
        return self._package

    @property
    def node_plugin(self) -> list[Substitution]:
        """Name of the plug-in."""
        return self._plugin

    @property
    def node_name(self) -> list[Substitution] | None:
        """Name of the node."""
        return self._name

    @property
    def node_namespace(self) -> list[Substitution] | None:
        """Namespace of the node."""
        return self._namespace

    @property
    def parameters(self) -> Parameters | None:
        """Parameters of the node, normalized."""
        return self._parameters

    @property
    def remappings(self) -> RemapRules | None:
        """Remappings of the node, normalized."""
        return self._remappings

    @property
    def extra_arguments(self) -> Parameters | None:
        """Arguments of the container for this node, normalized."""
        return self._extra_arguments

    def condition(self) -> Condition | None:
        """Return what decides whether the node is loaded."""
        return self._condition


def parse_composable_nodes(elements: Iterable[Entity], parser: ParsesActions) -> list[ComposableNode]:
    """Return the nodes of the tags `composable_node`."""
    nodes = []
    for element in elements:
        node_class, arguments = ComposableNode.parse(parser, element)
        nodes.append(node_class(**arguments))
    return nodes
