"""Nodes: the parts of a program that others see, with what they publish, subscribe to and run."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, TypeVar

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.base.node_entities import NodeEntities
from tfloom.node.base.node_graph import NodeGraph, resolve_name
from tfloom.node.builtin.logging_service import LoggingService
from tfloom.node.builtin.parameter_service import ParameterService
from tfloom.node.builtin.rosout import Rosout
from tfloom.node.builtin.time_source import TimeSource
from tfloom.node.builtin.type_description_service import TypeDescriptionService
from tfloom.node.clock.clock import Clock, ROSClock
from tfloom.node.context.arguments import Arguments, parse_arguments
from tfloom.node.context.utilities import get_default_context
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.service import SrvType, SrvTypeRequest, SrvTypeResponse
from tfloom.node.executing.entity import Entity
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.parameters.node_parameters import NodeParameters
from tfloom.node.parameters.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from tfloom.node.qos.qos import qos_profile_parameter_events
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.handle import Handle
from tfloom.node.values.names import validate_namespace, validate_node_name
from tfloom.rmw.base import NodeName
from tfloom.rosidl.message import Message

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.context.context import Context
    from tfloom.node.executing.executor import Executor

__all__ = [
    "HIDDEN_NODE_PREFIX",
    "PARAMETER_SEPARATOR_STRING",
    "S_TO_NS",
    "MsgType",
    "Node",
    "SrvType",
    "SrvTypeRequest",
    "SrvTypeResponse",
]

HIDDEN_NODE_PREFIX = "_"
PARAMETER_EVENTS_TOPIC = "/parameter_events"

MsgType = TypeVar("MsgType", bound=Message)
AnyEntity = TypeVar("AnyEntity", bound=Entity)


# Private names are mangled: programs derive from Node, and must be free to call their own things what they like.
class Node(NodeEntities, NodeParameters, NodeGraph):
    """A node: a name on the graph, under which it publishes, subscribes, and has parameters and timers.

    Its callbacks run while an executor that it is added to spins. Whoever holds something that it created holds the
    node; one that nobody holds leaves the graph when another node is created, or at shutdown.

    Args:
        node_name: Its name; `-r __node:=` on the command line replaces it.
        context: The context it belongs to; None: the default one.
        cli_args: Arguments for this node alone, `--ros-args` included; they come before the program's.
        namespace: Its namespace, with or without the first slash; None: the root. `-r __ns:=` replaces it.
        use_global_arguments: Whether the program's ROS arguments hold for it.
        enable_rosout: Whether its log records go to /rosout.
        start_parameter_services: Whether others may read and set its parameters.
        parameter_overrides: First values of parameters; they win over those of the command line.
        allow_undeclared_parameters: Whether parameters may be set that aren't declared.
        automatically_declare_parameters_from_overrides: Whether each parameter that is given a first value is
            declared at once.
        enable_logger_service: Whether others may read and set the levels of its loggers.

    Raises:
        NotInitializedException: the context isn't initialised, or shut down.
        InvalidNodeNameException: the name isn't valid.
        InvalidNamespaceException: the namespace isn't valid.
        RCLInvalidROSArgsError: one of `cli_args` makes no sense.
    """

    PARAM_REL_TOL = 1e-6

    _parameter_event_overriding: QoSOverridingOptions | None = None
    """What parameters may override of the publisher of parameter events: nothing, as in rclpy; rclcpp lets them."""

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        self.__context = context or get_default_context()
        self.__arguments = parse_arguments(cli_args or []).over(
            self.__context.arguments if use_global_arguments else Arguments()
        )
        self.__node_name = self.__settle_name(node_name, namespace or "/")
        self.__executor: weakref.ref[Executor] | None = None
        self.__destroyed = True  # until it is on the graph
        self.__parameter_event_publisher: Publisher[rcl_msg.ParameterEvent] | None = None
        self.__rosout: Rosout | None = None
        self.__time_source: TimeSource | None = None
        self.__clock = ROSClock()
        self.__logger = RcutilsLogger(self.__node_name.full.strip("/").replace("/", "."))
        NodeParameters.__init__(
            self,
            self.__first_values(parameter_overrides or []),
            allow_undeclared=allow_undeclared_parameters,
            publish_event=self.__publish_parameter_event,
        )
        self.__participant = self.__context.join(self.__node_name)
        NodeGraph.__init__(self, self.__participant.graph)
        NodeEntities.__init__(self, self.__participant, self.__node_name, self.__context)
        self.__destroyed = False
        try:
            self.__begin(
                rosout=enable_rosout,
                declare_overrides=automatically_declare_parameters_from_overrides,
                parameter_services=start_parameter_services,
                logger_service=enable_logger_service,
            )
        except BaseException:
            self.destroy_node()
            raise

    def __begin(
        self, *, rosout: bool, declare_overrides: bool, parameter_services: bool, logger_service: bool
    ) -> None:
        if rosout and self.__arguments.rosout_logs:
            self.__rosout = Rosout(self.__participant, self.__node_name, self.__logger.name)
        self.__parameter_event_publisher = self.create_publisher(
            rcl_msg.ParameterEvent,
            PARAMETER_EVENTS_TOPIC,
            qos_profile_parameter_events,
            qos_overriding_options=self._parameter_event_overriding,
        )
        if declare_overrides:
            for name, parameter in self._parameter_overrides.items():
                self.declare_parameter(
                    name, parameter.value, rcl_msg.ParameterDescriptor(dynamic_typing=True)
                )
        self.__time_source = TimeSource(node=self)
        self.__time_source.attach_clock(self.__clock)
        if parameter_services:
            ParameterService(self)
        if logger_service:
            LoggingService(self)
        TypeDescriptionService(self)

    def __settle_name(self, name: str, namespace: str) -> NodeName:
        validate_node_name(name)
        if not namespace.startswith("/"):
            namespace = f"/{namespace}"
        namespace = self.__arguments.namespace(name, namespace)
        validate_namespace(namespace)
        return NodeName(namespace, self.__arguments.node_name(name))

    def __first_values(self, overrides: list[Parameter]) -> dict[str, Parameter]:
        values = self.__arguments.parameter_overrides(self.__node_name.full)
        given = {name: Parameter(name, value=value) for name, value in values.items()}
        return given | {parameter.name: parameter for parameter in overrides}

    # What it is

    @property
    def context(self) -> Context:
        """The context it belongs to."""
        return self.__context

    @property
    def handle(self) -> Handle:
        """What stands for the library's own node."""
        return Handle(self)

    @property
    def executor(self) -> Executor | None:
        """The executor it was added to, or None."""
        return None if self.__executor is None else self.__executor()

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        current = self.executor
        if current is new_executor:
            return
        self.__executor = None if new_executor is None else weakref.ref(new_executor)
        if current is not None:
            current.remove_node(self)
        if new_executor is not None:
            new_executor.add_node(self)

    def get_name(self) -> str:
        """Return its name."""
        return self.__node_name.name

    def get_namespace(self) -> str:
        """Return its namespace, `/` or `/a/b`."""
        return self.__node_name.namespace

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""
        return self.__node_name.full

    def get_logger(self) -> RcutilsLogger:
        """Return its logger."""
        return self.__logger

    def get_clock(self) -> Clock:
        """Return its clock: ROS time."""
        return self.__clock

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return a topic's full name, remapped unless `only_expand`.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        return self.__resolve(topic, only_expand, is_service=False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return a service's full name, remapped unless `only_expand`.

        Raises:
            InvalidServiceNameException: the name isn't valid.
        """
        return self.__resolve(service, only_expand, is_service=True)

    def __resolve(self, name: str, only_expand: bool, *, is_service: bool) -> str:
        def remap(full_name: str) -> str | None:
            node = self.__node_name
            return self.__arguments.remap(full_name, node.name, node.namespace, is_service=is_service)

        return resolve_name(name, self.__node_name, None if only_expand else remap, is_service=is_service)

    def destroy_node(self) -> None:
        """Leave the executor and the graph, with all that was created. Destroying again does nothing."""
        if self.__destroyed:
            return
        self.__destroyed = True
        if self.__time_source is not None:
            self.__time_source.detach_node()
        self.executor = None
        self.__parameter_event_publisher = None
        self.destroy_entities()
        if self.__rosout is not None:
            self.__rosout.close()
        self.__context.leave(self.__node_name)

    def __del__(self) -> None:
        if not getattr(self, "_Node__destroyed", True):
            self.__context.abandon(self)

    def __publish_parameter_event(self, event: rcl_msg.ParameterEvent) -> None:
        if self.__parameter_event_publisher is not None and self.__context.ok():
            self.__parameter_event_publisher.publish(event)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy_node()
