"""A node without its built-in services: parameters, and the creation of publishers, services, timers and others."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, overload

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.base.node_entities import NodeEntities
from tfloom.node.base.node_names import NodeNames
from tfloom.node.base.owned_entities import OwnedEntities
from tfloom.node.clock.clock import ROSClock
from tfloom.node.context.arguments import Arguments
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.service_introspection import Introspection
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.endpoints.type_variables import MsgType, SrvTypeRequest, SrvTypeResponse
from tfloom.node.executing.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from tfloom.node.executing.event_handler import (
    EventHandler,
    PublisherEventCallbacks,
    SubscriptionEventCallbacks,
)
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.timer import Rate, Timer
from tfloom.node.log.rcutils_logger import RcutilsLogger
from tfloom.node.parameters.node_parameters import NodeParameters
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.qos.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from tfloom.node.qos.qos_overriding_options import QoSOverridingOptions, apply_overrides
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.set_by_init import SET_BY_INIT
from tfloom.node.values.stamps import check_fits_stamp
from tfloom.node.values.type_support import (
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from tfloom.rmw.typed_names import service_of, topic_of
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from types import TracebackType
    from typing import Literal

    from typing_extensions import Self

    from tfloom.node.clock.clock import Clock
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.service import ServiceCallback
    from tfloom.node.endpoints.subscription import SubscriptionCallback
    from tfloom.rmw.base import Reader, Topic, Writer

__all__ = ["NodeBase"]

PARAMETER_EVENTS_TOPIC = "/parameter_events"


# Private names are mangled, because programs derive from Node and choose names of their own.
class NodeBase(NodeEntities, NodeParameters):
    """A node without built-in services, which take an object of this class; Node adds them.

    All `create_…` methods raise InvalidHandle after the node was destroyed.

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

    __owned: OwnedEntities = SET_BY_INIT

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
        NodeParameters.__init__(
            self,
            first_values,
            allow_undeclared=allow_undeclared_parameters,
            publish_event=self.__publish_parameter_event,
        )
        participant = context.join(names.node)
        self.__owned = OwnedEntities(participant, names.node, context)
        NodeEntities.__init__(
            self,
            names,
            participant.graph,
            context=context,
            clock=ROSClock(),
            logger=RcutilsLogger(names.node.full.strip("/").replace("/", ".")),
            owned=self.__owned,
        )
        try:
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
        except BaseException:
            self.destroy_node()
            raise

    def __publish_parameter_event(self, event: rcl_msg.ParameterEvent) -> None:
        now = self.get_clock().now()
        check_fits_stamp(now.nanoseconds)
        event.stamp = now.to_msg()
        event.node = self.get_fully_qualified_name()
        if self.__parameter_event_publisher is not None and self.context.ok():
            self.__parameter_event_publisher.publish(event)

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
        check_is_valid_msg_type(msg_type)
        name = self.resolve_topic_name(topic)
        profile = self.__profile("publisher", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        writer = self.__owned.participant().create_writer(
            self.__owned.node_name, wire_topic, profile.to_wire()
        )
        group = callback_group or self.default_callback_group
        publisher = publisher_class(writer, msg_type, name, profile, None, group, context=self.context)
        self.__owned.add_publisher(publisher, self)
        self.__warn_of_other_type(wire_topic, publisher)
        try:
            publisher.event_handlers = self.__watch(
                event_callbacks or PublisherEventCallbacks(), group, writer, name
            )
        except BaseException:
            self.destroy_publisher(publisher)
            raise
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

        Raises:
            AttributeError: `msg_type` is not a ROS type.
            RuntimeError: `msg_type` is a service or an action.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            InvalidQosOverridesError: the parameters give an invalid profile.
            RuntimeError: `callback` takes neither one argument nor two.
            UnsupportedEventTypeError: the wire doesn't support an event that there is a callback for.
        """
        check_is_valid_msg_type(msg_type)
        name = self.resolve_topic_name(topic)
        profile = self.__profile("subscription", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        reader = self.__owned.participant().create_reader(
            self.__owned.node_name, wire_topic, profile.to_wire()
        )
        group = callback_group or self.default_callback_group
        try:
            subscription = Subscription(
                reader, msg_type, name, callback, group, profile, raw, None, logger=self.get_logger()
            )
        except BaseException:
            reader.close()
            raise
        self.__owned.add(subscription, self)
        self.__warn_of_other_type(wire_topic, subscription)
        try:
            subscription.event_handlers = self.__watch(
                event_callbacks or SubscriptionEventCallbacks(), group, reader, name
            )
        except BaseException:
            self.destroy_subscription(subscription)
            raise
        return subscription

    def __warn_of_other_type(self, topic: Topic, endpoint: Publisher[Any] | Subscription[Any]) -> None:
        other = self.context.topic_types.add(topic, endpoint)
        if other is not None:
            self.get_logger().warning(
                f"{topic.name} has two types in this program: {other}, and here {topic.type_name}. Messages pass "
                "only between endpoints of one type"
            )

    def __profile(
        self, kind: str, topic_name: str, qos_profile: QoSProfile | int, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        profile = _profile(qos_profile)
        if options is None:
            return profile
        return apply_overrides(self, kind, topic_name, profile, options)

    def __watch(
        self,
        callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks,
        group: CallbackGroup,
        endpoint: Writer | Reader,
        topic_name: str,
    ) -> list[EventHandler]:
        graph = self.__owned.participant().graph
        handlers = callbacks.create_event_handlers(
            group, endpoint, topic_name, logger=self.get_logger(), graph=graph
        )
        return [self.__owned.add(handler, self) for handler in handlers]

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
        """
        check_is_valid_srv_type(srv_type)
        name = self.resolve_service_name(srv_name)
        responder = self.__owned.participant().create_responder(
            self.__owned.node_name, service_of(srv_type, name), qos_profile.to_wire()
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
        return self.__owned.add(service, self)

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
        name = self.resolve_service_name(srv_name)
        requester = self.__owned.participant().create_requester(
            self.__owned.node_name, service_of(srv_type, name), qos_profile.to_wire()
        )
        client = Client(
            self.context,
            requester,
            srv_type,
            name,
            qos_profile,
            callback_group or self.default_callback_group,
            executor=lambda: self.executor,
            introspection=self.__introspection(srv_type, name),
            logger=self.get_logger(),
        )
        self.__owned.add(client, self)
        self.__owned.add(client.server_watch, self)
        return client

    def __introspection(self, srv_type: type[ServiceType], name: str) -> Introspection:
        return Introspection(srv_type, name, self.create_publisher, self.destroy_publisher)

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
            callback: Called without arguments, on a thread of the executor.
            callback_group: Its group; None: the node's own.
            clock: Clock of the period; None: the node's.
            autostart: Whether it is started at once; otherwise by its first `reset`.

        Raises:
            ValueError: the period is negative.
        """
        period_ns = int(float(timer_period_sec) * S_TO_NS)
        group = callback_group or self.default_callback_group
        timer = Timer(
            callback, group, period_ns, clock or self.get_clock(), context=self.context, autostart=autostart
        )
        return self.__owned.add(timer, self)

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition, whose callback runs after each trigger."""
        group = callback_group or self.default_callback_group
        return self.__owned.add(GuardCondition(callback, group, context=self.context), self)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate for a loop on a thread that doesn't spin the node.

        Args:
            frequency: Rate at which its `sleep` returns [Hz].
            clock: Clock of the period; None: the node's.

        Raises:
            ValueError: `frequency` isn't above 0.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, MutuallyExclusiveCallbackGroup(), clock)
        rate = Rate(timer, context=self.context)
        self.__owned.add_rate(rate)
        return rate

    def destroy_node(self) -> None:
        """Leave the executor and the graph, and destroy all that was created. Destroying again does nothing."""
        self.__parameter_event_publisher = None
        NodeEntities.destroy_node(self)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy_node()


def _profile(qos_profile: QoSProfile | int) -> QoSProfile:
    if isinstance(qos_profile, QoSProfile):
        return qos_profile
    if isinstance(qos_profile, bool) or not isinstance(qos_profile, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_profile)!r}")
    if qos_profile < 0:
        raise ValueError("history depth must be greater than or equal to zero")
    return QoSProfile(depth=qos_profile)
