"""A container of composable nodes, and what loads nodes into one."""

from __future__ import annotations

from typing import Any, List, Union  # noqa: UP035  # the type that `Entity.get_attr` takes for children

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.missing import marked_as_missing
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.descriptions.composable_node import ComposableNode, parse_composable_nodes
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type

__all__ = ["NEEDS_CPP", "ComposableNodeContainer", "LoadComposableNodes", "get_composable_node_load_request"]


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Describes nodes to be loaded into a container, which needs C++: executing it raises an error.

    Args:
        composable_node_descriptions: The nodes.
        target_container: The container, or its name.
        kwargs: As for Action.
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: list[ComposableNode],
        target_container: Union[SomeSubstitutionsType, ComposableNodeContainer],
        **kwargs: Any,
    ) -> None:
        ensure_argument_type(
            target_container,
            (*SomeSubstitutionsType_types_tuple, ComposableNodeContainer),
            "target_container",
            "LoadComposableNodes",
        )
        super().__init__(**kwargs)
        self._composable_nodes = composable_node_descriptions
        self._target_container = target_container

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        elements = entity.get_attr("composable_node", data_type=List[Entity])  # noqa: UP006
        kwargs["composable_node_descriptions"] = parse_composable_nodes(elements, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Raise RuntimeError, because this needs C++."""
        raise marked_as_missing(RuntimeError(f"LoadComposableNodes: {NEEDS_CPP}"))


def get_composable_node_load_request(
    composable_node_description: ComposableNode,  # noqa: ARG001
    context: LaunchContext,  # noqa: ARG001
) -> Any:
    """Raise RuntimeError, because the request is one to a container, which needs C++."""
    raise RuntimeError(f"get_composable_node_load_request: {NEEDS_CPP}")


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
        raise marked_as_missing(RuntimeError(f"ComposableNodeContainer: {NEEDS_CPP}"))
