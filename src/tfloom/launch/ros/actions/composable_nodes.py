"""A container of composable nodes, and what loads nodes into one.

Containers and composable nodes are C++, which tfloom has none of: it asks containers of others to load their nodes.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, List, Union  # the type that `Entity.get_attr` takes for children

from tfloom.launch.core.base_classes import (
    LaunchDescriptionEntity,
    SomeSubstitutionsType,
    SomeSubstitutionsType_types_tuple,
    SubstitutionFailure,
)
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.missing import marked_as_missing
from tfloom.launch.entities.action import Action
from tfloom.launch.events.event_handlers import OnProcessStart
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.ros import configurations
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.composable_node import ComposableNode, parse_composable_nodes
from tfloom.launch.ros.ros_adapters import get_ros_node
from tfloom.launch.ros.service_calls import call_service
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters, to_parameters_list
from tfloom.launch.ros.utilities.names import (
    add_node_name,
    get_node_name_count,
    make_namespace_absolute,
    prefix_namespace,
)
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import perform_some_substitutions, perform_substitutions
from tfloom.workspace.ament import PackageNotFoundError

if TYPE_CHECKING:
    from tfloom.interfaces.composition_interfaces.srv import LoadNode_Request, LoadNode_Response
    from tfloom.node.endpoints.client import Client

__all__ = ["NEEDS_CPP", "ComposableNodeContainer", "LoadComposableNodes", "get_composable_node_load_request"]


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Asks a container that runs, or will run, to load nodes, one after another.

    Args:
        composable_node_descriptions: The nodes.
        target_container: The container, or its full name.
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
        self._composable_node_descriptions = composable_node_descriptions
        self._target_container = target_container
        self._logger = get_logger("launch_ros.actions.load_composable_nodes")

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        kwargs["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        elements = entity.get_attr("composable_node", data_type=List[Entity])
        kwargs["composable_node_descriptions"] = parse_composable_nodes(elements, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Send the requests, on a thread that the launch waits for.

        Raises:
            RuntimeError: no launch runs, or the container is an action that was not executed.
            TypeError: a parameter's value has a type that parameters don't have.
        """
        from tfloom.interfaces.composition_interfaces.srv import LoadNode

        loop = context.asyncio_loop
        if loop is None:
            raise RuntimeError("nodes can't be loaded: no LaunchService runs")
        container = self._container_name(context)
        requests = [
            request
            for node in self._composable_node_descriptions
            if (request := get_composable_node_load_request(node, context)) is not None
        ]
        if requests:
            client = get_ros_node(context).create_client(LoadNode, f"{container}/_container/load_node")
            context.add_completion_future(
                loop.run_in_executor(None, self._load, client, container, requests, context)
            )

    def _container_name(self, context: LaunchContext) -> str:
        if isinstance(self._target_container, ComposableNodeContainer):
            return self._target_container.node_name
        return perform_some_substitutions(context, self._target_container)

    def _load(
        self, client: Client, container: str, requests: Sequence[LoadNode_Request], context: LaunchContext
    ) -> None:
        """Send the requests, each after the response to the one before it."""
        for request in requests:
            response = call_service(client, request, context, self._logger)
            loop = context.asyncio_loop
            if response is None or loop is None:
                return
            # The names of nodes are a variable of the context, which the launch's thread changes.
            loop.call_soon_threadsafe(self._report, context, container, request, response)

    def _report(
        self, context: LaunchContext, container: str, request: LoadNode_Request, response: LoadNode_Response
    ) -> None:
        name = response.full_node_name or request.node_name
        if not response.success:
            self._logger.error(
                "Failed to load node '%s' of type '%s' in container '%s': %s",
                name,
                request.plugin_name,
                container,
                response.error_message,
            )
            return
        self._logger.info("Loaded node '%s' in container '%s'", response.full_node_name, container)
        if not name:
            return
        add_node_name(context, name)
        if (count := get_node_name_count(context, name)) > 1:
            container_logger = get_logger(container)
            container_logger.warning(
                "there are now at least %d nodes with the name %s created within this launch context",
                count,
                name,
            )


def get_composable_node_load_request(
    composable_node_description: ComposableNode, context: LaunchContext
) -> LoadNode_Request | None:
    """Return the request of a container's service that loads a node; None if the node's condition does not hold.

    Args:
        composable_node_description: The node.
        context: The launch, whose remappings, parameters and namespace for all nodes the node has, too.

    Raises:
        TypeError: a parameter's value has a type that parameters don't have.
    """
    from tfloom.interfaces.composition_interfaces.srv import LoadNode

    node = composable_node_description
    condition = node.condition()
    if condition is not None and not condition.evaluate(context):
        return None
    request = LoadNode.Request()
    request.package_name = perform_substitutions(context, node.package)
    request.plugin_name = perform_substitutions(context, node.node_plugin)
    if node.node_name is not None:
        request.node_name = perform_substitutions(context, node.node_name)
    given_namespace = (
        None if node.node_namespace is None else perform_substitutions(context, node.node_namespace)
    )
    namespace = prefix_namespace(configurations.namespace(context), given_namespace)
    if namespace is not None:
        request.node_namespace = make_namespace_absolute(namespace)
    rules = [
        (perform_substitutions(context, name), perform_substitutions(context, replacement))
        for name, replacement in node.remappings or ()
    ]
    request.remap_rules = [
        f"{name}:={replacement}" for name, replacement in [*configurations.remappings(context), *rules]
    ]
    given = evaluate_parameters(context, node.parameters or [])
    request.parameters = _messages(context, request, [*_global_parameters(context), *given])
    extra = evaluate_parameters(context, node.extra_arguments or [])
    request.extra_arguments = _messages(context, request, extra)
    return request


def _global_parameters(context: LaunchContext) -> list[Any]:
    """Return what SetParameter and SetParametersFromFile have set, evaluated."""
    return [
        dict([parameter]) if isinstance(parameter, tuple) else Path(parameter).absolute()
        for parameter in configurations.global_parameters(context)
    ]


def _messages(context: LaunchContext, request: LoadNode_Request, evaluated: Sequence[Any]) -> list[Any]:
    parameters = to_parameters_list(context, request.node_name, request.node_namespace, evaluated)
    return [parameter.to_parameter_msg() for parameter in parameters]


NEEDS_CPP = (
    "composable nodes are C++ libraries, which a C++ container loads, and tfloom runs Python: start each node by "
    "launch_ros.actions.Node, or the launch file in a ROS 2 installation"
)


@expose_action("node_container")
class ComposableNodeContainer(Node):
    """Starts a container of composable nodes, and has it load nodes.

    Containers are C++ programs: where there is none, executing it raises an error.

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
        self._composable_node_descriptions = composable_node_descriptions

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions, ignore: list[str] | None = None
    ) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser, ignore)
        elements = entity.get_attr("composable_node", data_type=List[Entity], optional=True)
        if elements is not None:
            kwargs["composable_node_descriptions"] = parse_composable_nodes(elements, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the container; when it has started, ask it to load the nodes.

        Raises:
            RuntimeError: there is no such package or program.
        """
        try:
            entities = super().execute(context)
        except (PackageNotFoundError, SubstitutionFailure) as error:
            raise marked_as_missing(
                RuntimeError(f"ComposableNodeContainer: {NEEDS_CPP} ({error})")
            ) from error
        if self._composable_node_descriptions:
            load = LoadComposableNodes(
                composable_node_descriptions=self._composable_node_descriptions, target_container=self
            )
            on_start = OnProcessStart(target_action=self, on_start=[load], handle_once=True)
            context.register_event_handler(on_start)
        return entities
