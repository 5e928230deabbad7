"""A node without its built-in services: its names, graph, parameters, publishers, services, timers and others."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, overload

from tfloom.common.seconds import checked_timeout, not_a_number, to_nanoseconds, too_long
from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.base.base_classes import BaseNode
from tfloom.node.base.node_entities import NodeEntities
from tfloom.node.base.node_graph import NamesAndTypes, NodeGraph, actions_of_topics
from tfloom.node.base.node_names import NodeNames
from tfloom.node.clock.clock import Clock
from tfloom.node.context.arguments import Arguments
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.service_introspection import Introspection
from tfloom.node.endpoints.subscription import Subscription, callback_error
from tfloom.node.executing.callback_groups import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    group_error,
)
from tfloom.node.executing.event_handler import (
    EventHandler,
    PublisherEventCallbacks,
    SubscriptionEventCallbacks,
)
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.timer import Rate, Timer
from tfloom.node.executing.waitable_entity import WaitableEntity
from tfloom.node.log.logging_filters import FilterTable
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.parameters.node_parameters import NodeParameters
from tfloom.node.parameters.parameter import Parameter, no_parameter_error
from tfloom.node.parameters.parameter_declaration import warn_of_names_alone
from tfloom.node.qos.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions, apply_overrides
from tfloom.node.values.duration import INT64_MAX, S_TO_NS
from tfloom.node.values.exceptions import RCLError
from tfloom.node.values.handle import Handle
from tfloom.node.values.names import name_error
from tfloom.node.values.time import ClockType, check_fits_stamp
from tfloom.node.values.type_support import (
    MsgType,
    SrvTypeRequest,
    SrvTypeResponse,
    check_is_valid_srv_type,
    msg_type_error,
)
from tfloom.node.values.wrong_arguments import not_callable
from tfloom.rmw.shared.form_reader import create_reader
from tfloom.rmw.typed_names import other_type_text, service_of, topic_of
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from types import TracebackType
    from typing import Literal

    from typing_extensions import Self

    from tfloom.node.base.node_entities import Destroyable
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.content_filter import ContentFilter, ContentFilterOptions
    from tfloom.node.endpoints.service import ServiceCallback
    from tfloom.node.endpoints.subscription import SubscriptionCallback
    from tfloom.node.executing.entity import Entity
    from tfloom.node.executing.executor import Executor
    from tfloom.node.executing.timer import TimerCallback
    from tfloom.node.executing.waitable import Waitable
    from tfloom.node.qos.endpoint_info import ServiceEndpointInfo, TopicEndpointInfo
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["NodeBase", "as_profile", "open_endpoint", "profile_error"]

PARAMETER_EVENTS_TOPIC = "/parameter_events"
WireEndpoint = TypeVar("WireEndpoint")
_PreCallback = Callable[[list[Parameter]], list[Parameter]]
_SetCallback = Callable[[list[Parameter]], rcl_msg.SetParametersResult]
_PostCallback = Callable[[list[Parameter]], None]


class _SetByInit:
    """An attribute that `__init__` sets; until then, reading it raises an AttributeError that says what to call.

    A public method reads such an attribute itself, before it calls others that do, so that the error ends close to the
    program's line.
    """

    def __get__(self, instance: object, owner: type | None = None) -> NoReturn:
        name = type(instance).__name__
        # Python fills in the attribute's name where `name` and `obj` are not given, and would then suggest one of
        # the class's private names, which are not names for users.
        raise AttributeError(
            f"this {name} is not a node yet: {name}.__init__ has to call super().__init__('a_node_name') "
            "before it uses anything of a node",
            name=None,
            obj=instance,
        )


_SET_BY_INIT: Any = _SetByInit()


class _RclpyName:
    """A private attribute of rclpy's Node, which programs read, by that name.

    Without a setter: an attribute that a program's node assigns by the name is its own, and changes nothing here.
    """

    def __init__(self, read: Callable[[Any], Any]) -> None:
        self._read = read

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        return self if instance is None else self._read(instance)


# Private names are mangled, because programs derive from Node and choose their own names.
class NodeBase:
    """A node without built-in services.

    Node adds these services. They are made for an object of this class, so it is in a file that they can import.

    The work is done by three members: the node's graph, its parameters, and the entities that it has created. After the
    node was destroyed, all methods that need the graph, or publish, raise InvalidHandle; the others answer as before.

    Args:
        node_name: Its name; `__node:=` among the arguments replaces it.
        context: The context it belongs to.
        arguments: ROS arguments that apply to it.
        namespace: Its namespace, with or without the first slash; `__ns:=` among the arguments replaces it.
        parameter_overrides: First values of parameters; they take precedence over those of the arguments.
        allow_undeclared_parameters: Whether parameters may be set that aren't declared.
        declare_overrides: Whether each parameter that is given a first value is declared at once.

    Raises:
        NotInitializedException: the context isn't initialised, or shut down.
        InvalidNodeNameException: the name isn't valid.
        InvalidNamespaceException: the namespace isn't valid.
    """

    __graph: NodeGraph = _SET_BY_INIT
    __parameters: NodeParameters = _SET_BY_INIT
    __entities: NodeEntities = _SET_BY_INIT

    _context = _RclpyName(lambda self: self.context)
    _logger = _RclpyName(lambda self: self.get_logger())
    _clock = _RclpyName(lambda self: self.get_clock())
    _default_callback_group = _RclpyName(lambda self: self.default_callback_group)
    _publishers = _RclpyName(lambda self: list(self.publishers))
    _subscriptions = _RclpyName(lambda self: list(self.subscriptions))
    _clients = _RclpyName(lambda self: list(self.clients))
    _services = _RclpyName(lambda self: list(self.services))
    _timers = _RclpyName(lambda self: list(self.timers))
    _guards = _RclpyName(lambda self: list(self.guards))
    _parameters = _RclpyName(lambda self: self.__parameters.parameters)
    _descriptors = _RclpyName(lambda self: self.__parameters.descriptors)
    _parameter_overrides = _RclpyName(lambda self: self.__parameters.overrides)
    _allow_undeclared_parameters = _RclpyName(lambda self: self.__parameters.allow_undeclared)
    _pre_set_parameters_callbacks = _RclpyName(lambda self: self.__parameters.pre_set_callbacks)
    _on_set_parameters_callbacks = _RclpyName(lambda self: self.__parameters.on_set_callbacks)
    _post_set_parameters_callbacks = _RclpyName(lambda self: self.__parameters.post_set_callbacks)

    _parameter_event_overriding: QoSOverridingOptions | None = None
    """Overridable policies of the parameter event publisher: none, as in rclpy; rclcpp has some."""

    def __init__(
        self,
        node_name: str,
        *,
        context: Context,
        arguments: Arguments,
        namespace: str,
        parameter_overrides: list[Parameter],
        allow_undeclared_parameters: bool,
        declare_overrides: bool,
    ) -> None:
        names = NodeNames(node_name, namespace, arguments)
        overrides = arguments.parameter_overrides(names.node.full)
        first_values = {name: Parameter(name, value=value) for name, value in overrides.items()}
        first_values |= {parameter.name: parameter for parameter in parameter_overrides}
        self.__parameter_event_publisher: Publisher[rcl_msg.ParameterEvent] | None = None
        self.__parameters = NodeParameters(
            first_values,
            allow_undeclared=allow_undeclared_parameters,
            publish_event=self.__publish_parameter_event,
        )
        participant = context.join(names.node)
        self.__entities = NodeEntities(
            self,
            participant,
            names.node,
            context=context,
            clock=Clock(clock_type=ClockType.ROS_TIME),
            logger=RcutilsLogger(names.node.full.strip("/").replace("/", "."), FilterTable()),
        )
        self.__graph = NodeGraph(names, participant.graph)
        try:
            self.__parameter_event_publisher = self.create_publisher(
                rcl_msg.ParameterEvent,
                PARAMETER_EVENTS_TOPIC,
                qos_profile_parameter_events,
                qos_overriding_options=self._parameter_event_overriding,
            )
            if declare_overrides:
                for name, parameter in first_values.items():
                    self.declare_parameter(
                        name, parameter.value, rcl_msg.ParameterDescriptor(dynamic_typing=True)
                    )
        except BaseException:
            self.destroy_node()
            raise

    def __publish_parameter_event(self, event: rcl_msg.ParameterEvent) -> None:
        self.__graph.check_exists()
        now = self.get_clock().now()
        check_fits_stamp(now.nanoseconds)
        event.stamp = now.to_msg()
        event.node = self.get_fully_qualified_name()
        if self.__parameter_event_publisher is not None and self.context.ok():
            self.__parameter_event_publisher.publish(event)

    # The node, its clock, logger and executor

    @property
    def context(self) -> Context:
        """The context it belongs to."""
        return self.__entities.context

    @property
    def handle(self) -> Handle:
        """Proxy of the node, for code that expects rclpy's C handle; to enter it raises InvalidHandle after the end."""
        return Handle(self, self.__graph.check_exists)

    @property
    def executor(self) -> Executor | None:
        """The executor that it was added to last, even if it was removed from it; None: there was none.

        Setting it adds the node to the new executor, and removes it from the former one; None: removes it.
        """
        return self.__entities.last_executor

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        former = self.__entities.last_executor
        if new_executor is not None:
            new_executor.add_node(self)
        # One of tfloom's has taken the node from the former executor. One that does not derive from these may not have.
        if former is not None and former is not new_executor:
            former.remove_node(self)
        self.__entities.last_executor = new_executor

    def _enter_executor(self, executor: Executor) -> list[Entity]:
        """As in `SpunNode`; the setter of `executor` asks the executor, which calls this."""
        former = self.__entities.executor
        self.__entities.executor = executor
        if former is not None and former is not executor:
            former.remove_node(self)
        return self.__entities.entities()

    def _leave_executor(self, executor: Executor) -> list[Entity]:
        """As in `SpunNode`."""
        if self.__entities.executor is executor:
            self.__entities.executor = None
        return self.__entities.entities()

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""
        return self.__entities.logger

    def get_clock(self) -> Clock:
        """Return its clock: ROS time."""
        return self.__entities.clock

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of all entities created without one: one callback at a time."""
        return self.__entities.default_callback_group

    # Names, and the graph

    def get_name(self) -> str:
        """Return the node's name."""
        return self.__graph.node.name

    def get_namespace(self) -> str:
        """Return the node's namespace, `/` or `/a/b`."""
        return self.__graph.node.namespace

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""
        return self.__graph.node.full

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return a topic's full name, remapped unless `only_expand`.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        name = self.__graph.resolved(topic, only_expand=only_expand, is_service=False)
        if isinstance(name, Exception):
            raise name
        return name

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return a service's full name, remapped unless `only_expand`.

        Raises:
            InvalidServiceNameException: the name isn't valid.
        """
        name = self.__graph.resolved(service, only_expand=only_expand, is_service=True)
        if isinstance(name, Exception):
            raise name
        return name

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes, without their namespaces."""
        return [node.name for node in self.__graph.wire_graph.nodes()]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return [node.full for node in self.__graph.wire_graph.nodes()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return names and namespaces of all nodes."""
        return [(node.name, node.namespace) for node in self.__graph.wire_graph.nodes()]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return names, namespaces and enclaves of all nodes."""
        nodes = self.__graph.wire_graph.enclaves()
        return [(node.name, node.namespace, enclave) for node, enclave in nodes]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Wait until a node is on the graph; False if it isn't after `timeout` [s]."""
        if not isinstance(fully_qualified_node_name, str):
            given = f"{fully_qualified_node_name!r} of class {type(fully_qualified_node_name).__name__}"
            raise TypeError(f"wait_for_node() needs the full name of a node, as '/turtlesim', got {given}")
        return self.__graph.wait_for_node(
            fully_qualified_node_name, checked_timeout("wait_for_node", timeout)
        )

    def _wire(self) -> tuple[Participant, NodeName]:
        """Return the node's participant, and its name there, for tfloom's own nodes."""
        return self.__entities.participant(), self.__entities.node_name

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics, and the types they are written or read as.

        Args:
            no_demangle: Whether to return all topics on the wire, those of services and of other programs too, by
                their DDS names and types, such as `rt/pose` and `turtlesim::msg::dds_::Pose_`.
        """
        return self.__graph.topics(no_demangle)

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node publishes, with their types; `no_demangle` as in the above.

        Raises:
            NodeNameNonExistentError: there is no such node.
        """
        return self.__graph.topics_of_node(node_name, node_namespace, is_writer=True, no_demangle=no_demangle)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node subscribes to, with their types; `no_demangle` as in the above.

        Raises:
            NodeNameNonExistentError: there is no such node.
        """
        return self.__graph.topics_of_node(
            node_name, node_namespace, is_writer=False, no_demangle=no_demangle
        )

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services that have a server, with their types."""
        return self.__graph.services()

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node serves, with their types; RuntimeError if there is no such node."""
        return self.__graph.services_of_node(node_name, node_namespace, is_server=True)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node is a client of; RuntimeError if there is no such node."""
        return self.__graph.services_of_node(node_name, node_namespace, is_server=False)

    def count_services(self, service_name: str) -> int:
        """Return how many servers a service has; the name is expanded and remapped."""
        name = self.__graph.queried_name(service_name, is_service=True)
        return self.__graph.service_end_count(name, is_server=True)

    def count_clients(self, service_name: str) -> int:
        """Return how many clients a service has; the name is expanded and remapped."""
        name = self.__graph.queried_name(service_name, is_service=True)
        return self.__graph.service_end_count(name, is_server=False)

    def count_publishers(self, topic_name: str) -> int:
        """Return how many publishers a topic has, of all nodes; the name is expanded and remapped.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        return len(self.__graph.endpoints(self.__graph.queried_name(topic_name), is_writer=True))

    def count_subscribers(self, topic_name: str) -> int:
        """Return how many subscriptions a topic has, of all nodes; the name is expanded and remapped.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        return len(self.__graph.endpoints(self.__graph.queried_name(topic_name), is_writer=False))

    def get_publishers_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """Return the publishers of a topic.

        Args:
            topic_name: Its name, which is expanded and remapped.
            no_mangle: Whether it is DDS's own name, used unchanged; types are then DDS's own, too.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        name = topic_name if no_mangle else self.__graph.queried_name(topic_name)
        return self.__graph.endpoints(name, is_writer=True, no_mangle=no_mangle)

    def get_subscriptions_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic.

        Args:
            topic_name: Its name, which is expanded and remapped.
            no_mangle: Whether it is DDS's own name, used unchanged; types are then DDS's own, too.

        Raises:
            InvalidTopicNameException: the name isn't valid.
        """
        name = topic_name if no_mangle else self.__graph.queried_name(topic_name)
        return self.__graph.endpoints(name, is_writer=False, no_mangle=no_mangle)

    def get_clients_info_by_service(
        self, service_name: str, no_mangle: bool = False
    ) -> list[ServiceEndpointInfo]:
        """Return the clients of a service.

        Args:
            service_name: Its name, which is expanded and remapped.
            no_mangle: Whether it is the wire's own name of the topic of requests, used unchanged, as `rq/addRequest`.

        Raises:
            InvalidServiceNameException: the name isn't valid.
        """
        name = service_name if no_mangle else self.__graph.queried_name(service_name, is_service=True)
        return self.__graph.service_endpoints(name, is_server=False, no_mangle=no_mangle)

    def get_servers_info_by_service(
        self, service_name: str, no_mangle: bool = False
    ) -> list[ServiceEndpointInfo]:
        """Return the servers of a service.

        Args:
            service_name: Its name, which is expanded and remapped.
            no_mangle: Whether it is the wire's own name of the topic of requests, used unchanged, as `rq/addRequest`.

        Raises:
            InvalidServiceNameException: the name isn't valid.
        """
        name = service_name if no_mangle else self.__graph.queried_name(service_name, is_service=True)
        return self.__graph.service_endpoints(name, is_server=True, no_mangle=no_mangle)

    def get_action_names_and_types(self) -> NamesAndTypes:
        """Return all actions that have a server or a client, with their types."""
        return actions_of_topics(self.__graph.topics(no_demangle=False))

    def get_action_server_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions that a node serves, with their types; RuntimeError if there is no such node."""
        return actions_of_topics(self.get_publisher_names_and_types_by_node(node_name, node_namespace))

    def get_action_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions that a node is a client of, with their types; RuntimeError if there is no such node."""
        return actions_of_topics(self.get_subscriber_names_and_types_by_node(node_name, node_namespace))

    # Parameters

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: rcl_msg.ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter:
        """Declare one parameter, and return it with its initial value.

        Args:
            name: Its name.
            value: Its default, which fixes its type; or a Parameter.Type, for a parameter with no default.
            descriptor: Its description, and the values that it allows.
            ignore_override: Whether the initial value is the default even if the command line gives a value.

        Raises:
            TypeError: no parameter can have such a value; from Lyrical on also that there is only a name.
            ValueError: there is neither a value nor a type, and the descriptor doesn't allow dynamic typing.
            ParameterAlreadyDeclaredException: it was declared before.
            InvalidParameterException: the name is empty.
            InvalidParameterTypeException: the value given on the command line is of another type.
            InvalidParameterValueException: the initial value is out of range, or rejected by a callback.
        """
        only_name = value is None and descriptor is None
        declaration = (name,) if only_name else (name, value, descriptor or rcl_msg.ParameterDescriptor())
        error = self.__parameters.declaration_error("", [declaration])
        warn_of_names_alone("", [declaration], error)
        if error is not None:
            raise error
        return self.__parameters.declare_parameters("", [declaration], ignore_override)[0]

    def declare_parameters(
        self,
        namespace: str,
        parameters: Sequence[tuple[Any, ...]],
        ignore_override: bool = False,
    ) -> list[Parameter]:
        """Declare several parameters; each is a tuple of the first one to three arguments of `declare_parameter`.

        Args:
            namespace: Put before each name, with a dot; "" for none.
            parameters: The tuples.
            ignore_override: As for `declare_parameter`.

        Raises:
            TypeError: a tuple isn't of that form.
            ValueError: a type is NOT_SET, or given together with dynamic typing; or there is neither a value nor a
                type, and no dynamic typing.
            ParameterException: as from `declare_parameter`; the tuples before it in the list are then declared.
        """
        error = self.__parameters.declaration_error(namespace, parameters)
        warn_of_names_alone(namespace, parameters, error)
        if error is not None:
            raise error
        return self.__parameters.declare_parameters(namespace, parameters, ignore_override)

    def undeclare_parameter(self, name: str) -> None:
        """Remove a parameter.

        Raises:
            ParameterNotDeclaredException: it isn't declared.
            ParameterImmutableException: it is read-only.
        """
        self.__parameters.undeclare_parameter(name)

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return self.__parameters.has_parameter(name)

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
            ParameterUninitializedException: it was declared with a type and has no value.
        """
        return self.__parameters.get_parameter(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return the parameters of these names, each as `get_parameter` does.

        Raises:
            TypeError: `names` isn't a list of strings.
            ParameterException: as from `get_parameter`.
        """
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        parameters = self.__parameters
        return list(map(parameters.get_parameter, names))

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter; if it is undeclared or has no value, the alternative (None: one without value)."""
        return self.__parameters.get_parameter_or(name, alternative_value)

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters below a prefix (`a.b`; "" for all), by the part of their names after it."""
        return self.__parameters.get_parameters_by_prefix(prefix)

    def get_parameter_type(self, name: str) -> int:
        """Return the number of a parameter's type, a constant of `rcl_interfaces/msg/ParameterType`.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
        """
        return self.__parameters.get_parameter_type(name)

    def get_parameter_types(self, names: list[str]) -> list[int]:
        """Return the types of parameters, each as `get_parameter_type` does."""
        return self.__parameters.get_parameter_types(names)

    def describe_parameter(self, name: str) -> rcl_msg.ParameterDescriptor:
        """Return a parameter's descriptor.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
        """
        return self.__parameters.describe_parameter(name)

    def describe_parameters(self, names: list[str]) -> list[rcl_msg.ParameterDescriptor]:
        """Return the descriptors of parameters, each as `describe_parameter` does."""
        return self.__parameters.describe_parameters(names)

    def list_parameters(self, prefixes: list[str], depth: int) -> rcl_msg.ListParametersResult:
        """Return the names below any of the prefixes ([]: all names), at most `depth` parts deep (0: no limit).

        Raises:
            TypeError: an argument is of the wrong type.
            ValueError: `depth` is negative.
        """
        return self.__parameters.list_parameters(prefixes, depth)

    def set_parameters(self, parameter_list: list[Parameter]) -> list[rcl_msg.SetParametersResult]:
        """Set parameters one by one, and return a result for each: successful, or rejected with a reason.

        Raises:
            TypeError: an item is not a Parameter.
            ParameterNotDeclaredException: one isn't declared, and the node doesn't allow undeclared ones; those
                before it are then set.
        """
        if isinstance(parameter_list, Parameter) and (no_list := no_parameter_error(parameter_list)):
            raise no_list
        results: list[rcl_msg.SetParametersResult] = []
        for parameter in parameter_list:
            if (error := self.__parameters.setting_error([parameter])) is not None:
                raise error
            results.append(self.__parameters.set_atomically([parameter]))
        return results

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> rcl_msg.SetParametersResult:
        """Set all parameters, or none of them if one is rejected.

        Raises:
            TypeError: an item is not a Parameter.
            ParameterNotDeclaredException: one isn't declared, and the node doesn't allow undeclared ones.
        """
        if (error := self.__parameters.setting_error(parameter_list)) is not None:
            raise error
        return self.__parameters.set_atomically(parameter_list)

    def set_descriptor(
        self,
        name: str,
        descriptor: rcl_msg.ParameterDescriptor,
        alternative_value: rcl_msg.ParameterValue | None = None,
    ) -> rcl_msg.ParameterValue:
        """Replace a parameter's descriptor; set the alternative value if the descriptor doesn't allow the present one.

        Returns:
            The parameter's new value.

        Raises:
            ParameterNotDeclaredException: it isn't declared, and the node doesn't allow undeclared ones.
            ParameterImmutableException: it is read-only.
            InvalidParameterValueException: the descriptor allows neither value.
        """
        return self.__parameters.set_descriptor(name, descriptor, alternative_value)

    def add_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Set what `callback(parameters)` returns instead of `parameters`; the last added is called first.

        Raises:
            TypeError: `callback` can't be called.
        """
        if not callable(callback):
            raise TypeError(f"add_pre_set_parameters_callback() needs a callback, {not_callable(callback)}")
        self.__parameters.add_pre_set_parameters_callback(callback)

    def add_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Set and declare only what `callback(parameters)` accepts; the last added is called first.

        Raises:
            TypeError: `callback` can't be called.
        """
        if not callable(callback):
            raise TypeError(f"add_on_set_parameters_callback() needs a callback, {not_callable(callback)}")
        self.__parameters.add_on_set_parameters_callback(callback)

    def add_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Call `callback(parameters)` after each setting; the last added is called first.

        Raises:
            TypeError: `callback` can't be called.
        """
        if not callable(callback):
            raise TypeError(f"add_post_set_parameters_callback() needs a callback, {not_callable(callback)}")
        self.__parameters.add_post_set_parameters_callback(callback)

    def remove_pre_set_parameters_callback(self, callback: _PreCallback) -> None:
        """Undo one `add_pre_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__parameters.remove_pre_set_parameters_callback(callback)

    def remove_on_set_parameters_callback(self, callback: _SetCallback) -> None:
        """Undo one `add_on_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__parameters.remove_on_set_parameters_callback(callback)

    def remove_post_set_parameters_callback(self, callback: _PostCallback) -> None:
        """Undo one `add_post_set_parameters_callback`.

        Raises:
            ValueError: it wasn't added.
        """
        self.__parameters.remove_post_set_parameters_callback(callback)

    # Creating

    def create_publisher(
        self,
        msg_type: type[MsgType],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[MsgType]] = Publisher,
    ) -> Publisher[MsgType]:
        """Create a publisher.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic; it is expanded and remapped.
            qos_profile: QoS that it offers; a number is the depth of a KEEP_LAST history.
            callback_group: Group of its events' callbacks.
            event_callbacks: Callbacks for its events; None: a warning is logged about incompatible QoS.
            qos_overriding_options: Which policies parameters may override; None: none.
            publisher_class: Class of the publisher.

        Raises:
            AttributeError: `msg_type` is not a ROS type.
            RuntimeError: `msg_type` is a service or an action.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            InvalidQosOverridesError: the parameters give an invalid profile.
            UnsupportedEventTypeError: the wire doesn't support an event that there is a callback for.
        """
        error = msg_type_error(msg_type) or name_error(topic) or profile_error(qos_profile)
        error = error or group_error(callback_group)
        if error is not None:
            raise error
        entities = self.__entities
        name = self.resolve_topic_name(topic)
        profile = self.__profile("publisher", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        writer = entities.participant().create_writer(entities.node_name, wire_topic, profile.to_wire())
        group = callback_group or self.default_callback_group
        publisher = publisher_class(writer, msg_type, name, profile, None, group, context=self.context)
        publisher.topic = topic
        entities.add_publisher(publisher)
        try:
            publisher.event_handlers = entities.watch(
                event_callbacks or PublisherEventCallbacks(), group, writer, name
            )
        except BaseException:
            self.destroy_publisher(publisher)
            raise
        entities.warn_of_other_type(wire_topic, publisher)
        return publisher

    @overload
    def create_subscription(
        self,
        msg_type: type[MsgType],
        topic: str,
        callback: SubscriptionCallback[MsgType],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: Literal[False] = False,
        content_filter_options: ContentFilterOptions | None = None,
        acceptable_buffer_backends: str | None = None,
    ) -> Subscription[MsgType]: ...

    @overload
    def create_subscription(
        self,
        msg_type: type[MsgType],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool,
        content_filter_options: ContentFilterOptions | None = None,
        acceptable_buffer_backends: str | None = None,
    ) -> Subscription[MsgType]: ...

    def create_subscription(
        self,
        msg_type: type[MsgType],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
        content_filter_options: ContentFilterOptions | None = None,
        acceptable_buffer_backends: str | None = None,  # for the reference's signature
    ) -> Subscription[MsgType]:
        """Create a subscription.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic; it is expanded and remapped.
            callback: Called with a message, or a message and a dict of its stamps [ns], on a thread of the executor.
            qos_profile: QoS that it requests; a number is the depth of a KEEP_LAST history.
            callback_group: Group of its callbacks; None: the node's own.
            event_callbacks: Callbacks for its events; None: a warning is logged about incompatible QoS.
            qos_overriding_options: Which policies parameters may override; None: none.
            raw: Whether the callback takes bytes, encapsulation header and CDR, rather than messages.
            content_filter_options: An expression about the messages' fields; only those for which it is true are
                received. None: all. AND and OR bind equally, and are read from left to right.
            acceptable_buffer_backends: Unused, because buffers are of this computer's memory alone; kept for the
                signature of later releases.

        Raises:
            AttributeError: `msg_type` is not a ROS type.
            RuntimeError: `msg_type` is a service or an action.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            InvalidQosOverridesError: the parameters give an invalid profile.
            RuntimeError: `callback` takes neither one argument nor two.
            RCLError: the expression of `content_filter_options` can't be used with these messages.
            UnsupportedEventTypeError: the wire doesn't support an event that there is a callback for.
        """
        error = msg_type_error(msg_type) or name_error(topic) or profile_error(qos_profile)
        if (error := error or callback_error(callback) or group_error(callback_group)) is not None:
            raise error
        content_filter = _content_filter(msg_type, content_filter_options)
        entities = self.__entities
        name = self.resolve_topic_name(topic)
        profile = self.__profile("subscription", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        reader = create_reader(
            entities.participant(),
            entities.node_name,
            wire_topic,
            profile.to_wire(),
            self.get_logger().warning,
        )
        group = callback_group or self.default_callback_group
        try:
            subscription = Subscription(
                reader, msg_type, name, callback, group, profile, raw, None, logger=self.get_logger()
            )
        except BaseException:
            reader.close()
            raise
        subscription.topic = topic
        subscription.filter_by(content_filter)
        entities.add(subscription)
        try:
            subscription.event_handlers = entities.watch(
                event_callbacks or SubscriptionEventCallbacks(), group, reader, name
            )
        except BaseException:
            self.destroy_subscription(subscription)
            raise
        entities.warn_of_other_type(wire_topic, subscription)
        return subscription

    def __profile(
        self, kind: str, topic_name: str, qos_profile: QoSProfile | int, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        profile = as_profile(qos_profile)
        if options is None:
            return profile
        return apply_overrides(self.__parameters, kind, topic_name, profile, options)

    def create_service(
        self,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        callback: ServiceCallback[SrvTypeRequest, SrvTypeResponse],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service[SrvTypeRequest, SrvTypeResponse]:
        """Create a service.

        Args:
            srv_type: Class of the service.
            srv_name: Its name; it is expanded and remapped.
            callback: Called with a request and an empty response, on a thread of the executor; returns the response,
                or is a coroutine function that does.
            qos_profile: QoS of requests and responses.
            callback_group: Group of its callbacks; None: the node's own.

        Raises:
            AttributeError: `srv_type` is not a ROS type.
            RuntimeError: `srv_type` is a message or an action.
            InvalidServiceNameException: the name isn't valid.
            TypeError: `callback` can't be called.
        """
        check_is_valid_srv_type(srv_type)
        if (error := name_error(srv_name, is_service=True) or group_error(callback_group)) is not None:
            raise error
        if not callable(callback):
            raise TypeError(f"create_service() needs a callback, {not_callable(callback)}")
        entities = self.__entities
        name = self.resolve_service_name(srv_name)
        responder = entities.participant().create_responder(
            entities.node_name, service_of(srv_type, name), qos_profile.to_wire()
        )
        group = callback_group or self.default_callback_group
        service = Service(
            responder,
            srv_type,
            name,
            callback,
            group,
            qos_profile,
            introspection=self.__introspection(srv_type, name),
            logger=self.get_logger(),
        )
        service.srv_name = srv_name
        return entities.add(service)

    def create_client(
        self,
        srv_type: type[ServiceType[SrvTypeRequest, SrvTypeResponse]],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client[SrvTypeRequest, SrvTypeResponse]:
        """Create a client of a service.

        Args:
            srv_type: Class of the service.
            srv_name: Its name; it is expanded and remapped.
            qos_profile: QoS of requests and responses.
            callback_group: Unused, because responses are received in no callback group; kept for rclpy's signature.

        Raises:
            AttributeError: `srv_type` is not a ROS type.
            RuntimeError: `srv_type` is a message or an action.
            InvalidServiceNameException: the name isn't valid.
        """
        check_is_valid_srv_type(srv_type)
        if (error := name_error(srv_name, is_service=True)) is not None:
            raise error
        entities = self.__entities
        name = self.resolve_service_name(srv_name)
        requester = entities.participant().create_requester(
            entities.node_name, service_of(srv_type, name), qos_profile.to_wire()
        )
        client = Client(
            self.context,
            requester,
            srv_type,
            name,
            qos_profile,
            callback_group or self.default_callback_group,
            executor=lambda: entities.executor,
            start_timer=self._start_internal_timer,
            introspection=self.__introspection(srv_type, name),
            logger=self.get_logger(),
            other_type=lambda: other_type_text(entities.participant().graph, name, srv_type._TYPE_NAME),
        )
        client.srv_name = srv_name
        entities.add(client)
        entities.add(client.server_watch)
        return client

    def _start_internal_timer(self, period_s: float, callback: Callable[[], None]) -> Timer:
        """Create a timer on the steady clock, for tfloom's own services of a node."""
        clock = Clock(clock_type=ClockType.STEADY_TIME)
        # Without a callback group, which distinguishes it from the program's timers.
        return self.__entities.add(
            Timer(callback, None, to_nanoseconds(period_s), clock, context=self.context)
        )

    def __introspection(self, srv_type: type[ServiceType], name: str) -> Introspection:
        return Introspection(srv_type, name, self.create_publisher, self.destroy_publisher)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: TimerCallback | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer.

        Args:
            timer_period_sec: The period [s].
            callback: Called on a thread of the executor; None, with a warning, only wakes it. A parameter that is
                annotated as `rclpy.timer.TimerInfo` gets the times of the call; there are no other arguments.
            callback_group: Its group; None: the node's own.
            clock: Clock of the period; None: the node's.
            autostart: Whether it is started at once; otherwise by its first `reset`.

        Raises:
            ValueError: the period is negative, NaN, a text, or longer than 292 years.
            TypeError: the period is not a number, or `callback` can't be called.
        """
        try:
            period_ns = to_nanoseconds(timer_period_sec)
        except (TypeError, ValueError) as error:
            raise type(error)(
                f"create_timer() {not_a_number('a period in seconds', timer_period_sec)}"
            ) from None
        except OverflowError:  # infinite
            period_ns = INT64_MAX + 1
        if callback is None:
            warnings.warn(f"create_timer() has no callback, {not_callable(None)}", stacklevel=2)
        elif not callable(callback):
            raise TypeError(f"create_timer() needs a callback, {not_callable(callback)}")
        if period_ns < 0:
            raise ValueError(f"timer period must be non-negative, not {period_ns / S_TO_NS} s")
        if period_ns > INT64_MAX:
            raise ValueError(f"create_timer() {too_long('period', timer_period_sec)}")
        if (wrong_group := group_error(callback_group)) is not None:
            raise wrong_group
        return self.__entities.add(
            self.__timer(period_ns, callback, callback_group, clock, autostart=autostart)
        )

    def __timer(
        self,
        period_ns: int,
        callback: TimerCallback | None,
        callback_group: CallbackGroup | None,
        clock: Clock | None,
        *,
        autostart: bool = True,
    ) -> Timer:
        group = callback_group or self.default_callback_group
        return Timer(
            callback, group, period_ns, clock or self.get_clock(), context=self.context, autostart=autostart
        )

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition, whose callback runs after each trigger."""
        if (error := group_error(callback_group)) is not None:
            raise error
        entities = self.__entities
        group = callback_group or self.default_callback_group
        return entities.add(GuardCondition(callback, group, context=self.context))

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate for a loop on a thread that doesn't spin the node.

        Args:
            frequency: Rate at which its `sleep` returns [Hz].
            clock: Clock of the period; None: the node's.

        Raises:
            TypeError: `frequency` is not a number.
            ValueError: `frequency` isn't above 0, or its period is longer than 292 years.
        """
        if not hasattr(frequency, "__float__"):
            raise TypeError(f"create_rate() {not_a_number('a frequency in Hz', frequency)}")
        hertz = float(frequency)  # a float16 would round the period, too
        if not hertz > 0:
            raise ValueError("frequency must be > 0")
        period_ns = to_nanoseconds(1.0 / hertz)
        if period_ns > INT64_MAX:
            raise ValueError(f"create_rate() {too_long('period', frequency)}")
        timer = self.__entities.add(self.__timer(period_ns, None, MutuallyExclusiveCallbackGroup(), clock))
        rate = Rate(timer, context=self.context)
        self.__entities.add_rate(rate)
        return rate

    # What was created

    @property
    def publishers(self) -> Iterator[Publisher[Any]]:
        """The publishers that the node created."""
        return iter(self.__entities.publishers())

    @property
    def subscriptions(self) -> Iterator[Subscription[Any]]:
        """The subscriptions that the node created."""
        return (entity for entity in self.__entities.entities() if isinstance(entity, Subscription))

    @property
    def services(self) -> Iterator[Service]:
        """The services that the node created."""
        return (entity for entity in self.__entities.entities() if isinstance(entity, Service))

    @property
    def clients(self) -> Iterator[Client]:
        """The clients that the node created."""
        return (entity for entity in self.__entities.entities() if isinstance(entity, Client))

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers that the node created."""
        timers = (entity for entity in self.__entities.entities() if isinstance(entity, Timer))
        return (timer for timer in timers if timer.callback_group is not None)

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions that the node created."""
        return (entity for entity in self.__entities.entities() if isinstance(entity, GuardCondition))

    @property
    def waitables(self) -> Iterator[Waitable]:
        """The waitables that were added."""
        return (
            entity.waitable for entity in self.__entities.entities() if isinstance(entity, WaitableEntity)
        )

    def add_waitable(self, waitable: Waitable | EventHandler) -> None:
        """Add a waitable, or an event handler, to those that the node's executor waits for."""
        if isinstance(waitable, EventHandler):
            self.__entities.add(waitable)
        else:
            self.__entities.add(WaitableEntity(waitable, lambda: self.__entities.executor))

    def remove_waitable(self, waitable: Waitable | EventHandler) -> None:
        """Undo `add_waitable`.

        Raises:
            ValueError: it was never added.
        """
        for entity in self.__entities.entities():
            if entity is waitable or (isinstance(entity, WaitableEntity) and entity.waitable is waitable):
                self.__entities.destroy(entity)
                return
        raise ValueError(f"{waitable!r} is not a waitable of this node")

    # Destroying

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher; False if it isn't this node's."""
        return self.__entities.destroy_publisher(publisher)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription; False if it isn't this node's."""
        return self.__entities.destroy(subscription)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service; False if it isn't this node's."""
        return self.__entities.destroy(service)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client; False if it isn't this node's. Its pending requests are cancelled."""
        # Programs also pass an ActionClient, which is not one of the node's: that has its own `destroy`.
        return self.__entities.destroy(client)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it isn't this node's."""
        return self.__entities.destroy(timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it isn't this node's."""
        return self.__entities.destroy(guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; False if it isn't this node's."""
        return self.__entities.destroy_rate(rate)

    def destroy_entities(self) -> None:
        """Destroy all that was created."""
        self.__entities.destroy_all()

    def destroy_node(self) -> None:
        """Leave the executor and the graph, and destroy all that was created, since a destruction before, too."""
        entities = self.__entities
        if entities.has_left:
            self.destroy_entities()
            return
        entities.has_left = True
        self.__graph.leave()
        self.__parameter_event_publisher = None
        # `executor` still answers with the last one, as in rclpy.
        last_executor = entities.last_executor
        if last_executor is not None:
            last_executor.remove_node(self)
        self.destroy_entities()
        entities.context.leave(entities.node_name)

    def __del__(self) -> None:
        entities: NodeEntities | None = self.__dict__.get("_NodeBase__entities")
        if entities is not None and not entities.has_left:
            entities.context.abandon(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy_node()

    def _open_endpoint(
        self, endpoint: Destroyable, create: Callable[[Participant, NodeName], WireEndpoint]
    ) -> WireEndpoint:
        """As `open_endpoint`."""
        return self.__entities.open(endpoint, create)


BaseNode.register(NodeBase)


def as_profile(qos_profile: QoSProfile | int) -> QoSProfile:
    """Return a profile as it is, and a depth as a profile of it."""
    return qos_profile if isinstance(qos_profile, QoSProfile) else QoSProfile(depth=qos_profile)


def _content_filter(msg_type: type[MsgType], options: ContentFilterOptions | None) -> ContentFilter | None:
    if options is None:
        return None
    from tfloom.node.endpoints.content_filter import ContentFilter, ContentFilterOptions, FilterError

    if not (hasattr(options, "filter_expression") and hasattr(options, "expression_parameters")):
        raise TypeError(
            f"content_filter_options must be ContentFilterOptions, got {options!r}: "
            "write ContentFilterOptions('data > %0', ['5'])"
        )
    whole = ContentFilterOptions(options.filter_expression, options.expression_parameters)
    try:
        return ContentFilter(msg_type, whole)
    except FilterError as error:
        raise RCLError(f"Failed to set content_filter_options: {error}") from None


def profile_error(qos_profile: Any) -> Exception | None:
    """Return the error of what is neither a profile nor a depth."""
    if isinstance(qos_profile, QoSProfile):
        return None
    if isinstance(qos_profile, bool) or not isinstance(qos_profile, int):
        given = f"{type(qos_profile)!r}"
        return TypeError(f"Expected QoSProfile or int, but received {given}: a depth is a number, as 10")
    if qos_profile < 0:
        return ValueError("history depth must be greater than or equal to zero")
    return None


def open_endpoint(
    node: NodeBase, endpoint: Destroyable, create: Callable[[Participant, NodeName], WireEndpoint]
) -> WireEndpoint:
    """Return what `create` makes on the wire for `endpoint`, which no executor runs and is destroyed with the node.

    Raises:
        InvalidHandle: the node was destroyed.
    """
    return node._open_endpoint(endpoint, create)
