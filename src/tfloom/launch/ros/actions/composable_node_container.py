"""The action that would start a container of nodes in C++."""

from __future__ import annotations

from typing import Any, List  # noqa: UP035  # the type that `Entity.get_attr` takes for children

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.descriptions.composable_node import ComposableNode, parse_composable_nodes
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType

__all__ = ["NEEDS_CPP", "ComposableNodeContainer"]

NEEDS_CPP = (
    "composable nodes are C++ libraries, which a C++ container loads, and tfloom runs Python: start each node by "
    "launch_ros.actions.Node, or the launch file in a ROS 2 installation"
)


@expose_action("node_container")
class ComposableNodeContainer(Node):
    """Describes a container of composable nodes, which needs C++: executing it raises an error.

    Args:
        name: Name of the container.
        namespace: Namespace of the container.
        composable_node_descriptions: The nodes to load into it.
        kwargs: As for Node.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: list[ComposableNode] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self._composable_nodes = composable_node_descriptions

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions, ignore: list[str] | None = None
    ) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser, ignore)
        elements = entity.get_attr("composable_node", data_type=List[Entity], optional=True)  # noqa: UP006
        if elements is not None:
            kwargs["composable_node_descriptions"] = parse_composable_nodes(elements, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Raise RuntimeError, because this needs C++."""
        raise RuntimeError(f"ComposableNodeContainer: {NEEDS_CPP}")
