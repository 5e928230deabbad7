"""Nodes: the parts of a program that others see, with what they publish, subscribe to and run."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.arguments import Arguments, parse_arguments
from tfloom.node.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from tfloom.node.clock import Clock, ROSClock
from tfloom.node.constants import S_TO_NS
from tfloom.node.entity import Entity
from tfloom.node.guard_condition import GuardCondition
from tfloom.node.names import validate_namespace, validate_node_name
from tfloom.node.node_graph import NodeGraph, resolve_name
from tfloom.node.node_parameters import NodeParameters
from tfloom.node.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from tfloom.node.publisher import Publisher
from tfloom.node.qos import QoSProfile, qos_profile_parameter_events
from tfloom.node.rcutils_logger import RcutilsLogger
from tfloom.node.rosout import Rosout
from tfloom.node.subscription import Subscription
from tfloom.node.time_source import TimeSource
from tfloom.node.timer import Rate, Timer
from tfloom.node.type_support import check_is_valid_msg_type, topic_of
from tfloom.node.utilities import get_default_context
from tfloom.rmw.base import NodeName
from tfloom.rosidl.message import Message

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.context import Context
    from tfloom.node.executor import Executor

__all__ = ["HIDDEN_NODE_PREFIX", "PARAMETER_SEPARATOR_STRING", "S_TO_NS", "MsgType", "Node"]

HIDDEN_NODE_PREFIX = "_"
PARAMETER_EVENTS_TOPIC = "/parameter_events"

MsgType = TypeVar("MsgType", bound=Message)
AnyEntity = TypeVar("AnyEntity", bound=Entity)


# Private names are mangled: programs derive from Node, and must be free to call their own things what they like.
class Node(NodeParameters, NodeGraph):
    """A node: a name on the graph, under which it publishes, subscribes, and has parameters and timers.

    Its callbacks run while an executor that it is added to spins.

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

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,  # noqa: ARG002
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        if enable_logger_service:
            raise NotImplementedError("enable_logger_service=True isn't there yet")
        self.__context = context or get_default_context()
        self.__arguments = parse_arguments(cli_args or []).over(
            self.__context.arguments if use_global_arguments else Arguments()
        )
        self.__node_name = self.__settle_name(node_name, namespace or "/")
        self.__entities: list[Entity] = []
        self.__publishers: list[Publisher[Any]] = []
        self.__rates: list[Rate] = []
        self.__executor: weakref.ref[Executor] | None = None
        self.__destroyed = False
        self.__parameter_event_publisher: Publisher[rcl_msg.ParameterEvent] | None = None
        self.__rosout: Rosout | None = None
        self.__default_callback_group = MutuallyExclusiveCallbackGroup()
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
        if enable_rosout and self.__arguments.rosout_logs:
            self.__rosout = Rosout(self.__participant, self.__node_name, self.__logger.name)
        self.__parameter_event_publisher = self.create_publisher(
            rcl_msg.ParameterEvent, PARAMETER_EVENTS_TOPIC, qos_profile_parameter_events
        )
        if automatically_declare_parameters_from_overrides:
            for name, parameter in self._parameter_overrides.items():
                self.declare_parameter(
                    name, parameter.value, rcl_msg.ParameterDescriptor(dynamic_typing=True)
                )
        self.__time_source = TimeSource(node=self)
        self.__time_source.attach_clock(self.__clock)

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
    def handle(self) -> Self:
        """What stands for the library's own node: this object."""
        return self

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of whatever is created without one: one callback at a time."""
        return self.__default_callback_group

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

    # What it has

    def entities(self) -> list[Entity]:
        """Return all that an executor is to run."""
        return list(self.__entities)

    @property
    def publishers(self) -> Iterator[Publisher[Any]]:
        """The publishers it created."""
        return iter(list(self.__publishers))

    @property
    def subscriptions(self) -> Iterator[Subscription[Any]]:
        """The subscriptions it created."""
        return (each for each in self.entities() if isinstance(each, Subscription))

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers it created."""
        return (each for each in self.entities() if isinstance(each, Timer))

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions it created."""
        return (each for each in self.entities() if isinstance(each, GuardCondition))

    def __add(self, entity: AnyEntity) -> AnyEntity:
        if entity.callback_group is not None:
            entity.callback_group.add_entity(entity)
        self.__entities.append(entity)
        executor = self.executor
        if executor is not None:
            executor.add_entity(entity)
        return entity

    def __remove(self, entity: Entity) -> bool:
        if entity not in self.__entities:
            return False
        self.__entities.remove(entity)
        executor = self.executor
        if executor is not None:
            executor.remove_entity(entity)
        return True

    def create_publisher(
        self,
        msg_type: type[MsgType],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        publisher_class: type[Publisher[MsgType]] = Publisher,
    ) -> Publisher[MsgType]:
        """Create a publisher.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic; it is expanded and remapped.
            qos_profile: What it offers; a number stands for a history of that depth.
            callback_group: Group of its events' callbacks.
            event_callbacks: Not there yet.
            qos_overriding_options: Not there yet.
            publisher_class: Class of the publisher.

        Raises:
            NoTypeSupportImportedException: `msg_type` is no message class.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
        """
        check_is_valid_msg_type(msg_type)
        _refuse("create_publisher", event_callbacks, qos_overriding_options)
        profile = _profile(qos_profile)
        name = self.resolve_topic_name(topic)
        wire_topic = topic_of(msg_type, name)
        writer = self.__participant.create_writer(self.__node_name, wire_topic, profile.to_wire())
        group = callback_group or self.__default_callback_group
        publisher = publisher_class(writer, msg_type, name, profile, None, group, context=self.__context)
        self.__publishers.append(publisher)
        return publisher

    def create_subscription(
        self,
        msg_type: type[MsgType],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> Subscription[MsgType]:
        """Create a subscription.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic; it is expanded and remapped.
            callback: Takes a message, or a message and a dict of its stamps [ns]. Runs on a thread of the executor.
            qos_profile: What it asks for; a number stands for a history of that depth.
            callback_group: Group of its callbacks; None: the node's own.
            event_callbacks: Not there yet.
            qos_overriding_options: Not there yet.
            raw: Whether the callback takes bytes, encapsulation header and CDR, rather than messages.

        Raises:
            NoTypeSupportImportedException: `msg_type` is no message class.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            RuntimeError: `callback` takes neither one argument nor two.
        """
        check_is_valid_msg_type(msg_type)
        _refuse("create_subscription", event_callbacks, qos_overriding_options)
        profile = _profile(qos_profile)
        name = self.resolve_topic_name(topic)
        wire_topic = topic_of(msg_type, name)
        reader = self.__participant.create_reader(self.__node_name, wire_topic, profile.to_wire())
        group = callback_group or self.__default_callback_group
        try:
            subscription = Subscription(
                reader, msg_type, name, callback, group, profile, raw, None, logger=self.__logger
            )
        except BaseException:
            reader.close()
            raise
        return self.__add(subscription)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer.

        Args:
            timer_period_sec: The period [s].
            callback: Takes nothing. Runs on a thread of the executor.
            callback_group: Its group; None: the node's own.
            clock: Counts the period; None: the node's.
            autostart: Whether it runs from the start; else from its first `reset`.

        Raises:
            ValueError: the period is negative.
        """
        period_ns = int(float(timer_period_sec) * S_TO_NS)
        group = callback_group or self.__default_callback_group
        timer = Timer(
            callback, group, period_ns, clock or self.__clock, context=self.__context, autostart=autostart
        )
        return self.__add(timer)

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition, whose callback runs after it is triggered."""
        group = callback_group or self.__default_callback_group
        return self.__add(GuardCondition(callback, group, context=self.__context))

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate for a loop on a thread that doesn't spin the node.

        Args:
            frequency: How often its `sleep` returns [Hz].
            clock: Counts the period; None: the node's.

        Raises:
            ValueError: `frequency` isn't above 0.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, MutuallyExclusiveCallbackGroup(), clock)
        rate = Rate(timer, context=self.__context)
        self.__rates.append(rate)
        return rate

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher; False if it isn't this node's."""
        if publisher not in self.__publishers:
            return False
        self.__publishers.remove(publisher)
        publisher.destroy()
        return True

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription; False if it isn't this node's."""
        removed = self.__remove(subscription)
        if removed:
            subscription.destroy()
        return removed

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it isn't this node's."""
        removed = self.__remove(timer)
        if removed:
            timer.destroy()
        return removed

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it isn't this node's."""
        removed = self.__remove(guard)
        if removed:
            guard.destroy()
        return removed

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; False if it isn't this node's."""
        if rate not in self.__rates:
            return False
        self.__rates.remove(rate)
        self.__remove(rate.timer)
        rate.destroy()
        return True

    def destroy_node(self) -> None:
        """Leave the executor and the graph, with all that was created. Destroying again does nothing."""
        if self.__destroyed:
            return
        self.__destroyed = True
        self.__time_source.detach_node()
        self.executor = None
        for rate in list(self.__rates):
            self.destroy_rate(rate)
        for entity in self.entities():
            self.__entities.remove(entity)
            entity.destroy()
        self.__parameter_event_publisher = None
        for publisher in list(self.__publishers):
            self.destroy_publisher(publisher)
        if self.__rosout is not None:
            self.__rosout.close()
        self.__context.leave(self.__node_name)

    def __publish_parameter_event(self, event: rcl_msg.ParameterEvent) -> None:
        if self.__parameter_event_publisher is not None and self.__context.ok():
            self.__parameter_event_publisher.publish(event)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy_node()


def _refuse(method: str, event_callbacks: Any, qos_overriding_options: Any) -> None:
    for name, value in (
        ("event_callbacks", event_callbacks),
        ("qos_overriding_options", qos_overriding_options),
    ):
        if value is not None:
            raise NotImplementedError(f"{method}({name}=...) isn't there yet")


def _profile(qos_profile: QoSProfile | int) -> QoSProfile:
    if isinstance(qos_profile, QoSProfile):
        return qos_profile
    if isinstance(qos_profile, bool) or not isinstance(qos_profile, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_profile)!r}")
    if qos_profile < 0:
        raise ValueError("History depth must be greater than or equal to 0")
    return QoSProfile(depth=qos_profile)
