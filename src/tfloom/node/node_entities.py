"""What a node creates and destroys: publishers, subscriptions, services, clients, timers and the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.node.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from tfloom.node.client import Client
from tfloom.node.constants import S_TO_NS
from tfloom.node.entity import Entity
from tfloom.node.event_handler import EventHandler, PublisherEventCallbacks, SubscriptionEventCallbacks
from tfloom.node.exceptions import InvalidHandle
from tfloom.node.guard_condition import GuardCondition
from tfloom.node.node_parameters import NodeParameters
from tfloom.node.publisher import Publisher
from tfloom.node.qos import QoSProfile, qos_profile_services_default
from tfloom.node.qos_overriding_options import QoSOverridingOptions, apply_overrides
from tfloom.node.service import Service
from tfloom.node.service_introspection import Introspection
from tfloom.node.subscription import Subscription
from tfloom.node.timer import Rate, Timer
from tfloom.node.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from tfloom.node.wait_set import WaitableEntity
from tfloom.rmw.typed_names import service_of, topic_of
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from tfloom.node.clock import Clock
    from tfloom.node.context import Context
    from tfloom.node.endpoint import Endpoint
    from tfloom.node.executor import Executor
    from tfloom.node.rcutils_logger import RcutilsLogger
    from tfloom.node.waitable import Waitable
    from tfloom.rmw.base import NodeName, Participant, Reader, Writer

__all__ = ["NodeEntities"]

MsgType = TypeVar("MsgType", bound=Message)
AnyEntity = TypeVar("AnyEntity", bound=Entity)
WireEnd = TypeVar("WireEnd")


class NodeEntities:
    """Creates and destroys what a node has; a base of Node.

    All that creates raises InvalidHandle once the node is destroyed.
    """

    def __init__(self, participant: Participant, node_name: NodeName, context: Context) -> None:
        self.__participant = participant
        self.__node_name = node_name
        self.__context = context
        self.__entities: list[Entity] = []
        self.__publishers: list[Publisher[Any]] = []
        self.__rates: list[Rate] = []
        self.__unspun: list[Endpoint[Any]] = []
        self.__default_callback_group = MutuallyExclusiveCallbackGroup()
        self.__destroyed = False

    @property
    def executor(self) -> Executor | None:
        """The executor the node was added to, or None."""
        raise NotImplementedError

    def get_clock(self) -> Clock:
        """Return the node's clock."""
        raise NotImplementedError

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""
        raise NotImplementedError

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return a topic's full name."""
        raise NotImplementedError

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return a service's full name."""
        raise NotImplementedError

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of whatever is created without one: one callback at a time."""
        return self.__default_callback_group

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
    def services(self) -> Iterator[Service]:
        """The services it created."""
        return (each for each in self.entities() if isinstance(each, Service))

    @property
    def clients(self) -> Iterator[Client]:
        """The clients it created."""
        return (each for each in self.entities() if isinstance(each, Client))

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers it created."""
        return (each for each in self.entities() if isinstance(each, Timer))

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions it created."""
        return (each for each in self.entities() if isinstance(each, GuardCondition))

    @property
    def waitables(self) -> Iterator[Waitable]:
        """The waitables that were added."""
        return (each.waitable for each in self.entities() if isinstance(each, WaitableEntity))

    def add_waitable(self, waitable: Waitable) -> None:
        """Have the node's executor wait for a waitable, too."""
        self.__add(WaitableEntity(waitable, lambda: self.executor))

    def remove_waitable(self, waitable: Waitable) -> None:
        """Wait for a waitable no more.

        Raises:
            ValueError: it was never added.
        """
        for each in self.entities():
            if isinstance(each, WaitableEntity) and each.waitable is waitable:
                self.__destroy(each)
                return
        raise ValueError(f"{waitable!r} is no waitable of this node")

    def _open(self, end: Endpoint[Any], make: Callable[[Participant, NodeName], WireEnd]) -> WireEnd:
        """Return an end on the wire for `end`, which no executor runs; it is destroyed with the node."""
        made = make(self.__wire(), self.__node_name)
        self.__unspun.append(end)
        return made

    def __wire(self) -> Participant:
        if self.__destroyed:
            raise InvalidHandle(f"cannot create anything for {self.__node_name.full}: the node was destroyed")
        return self.__participant

    def __add(self, entity: AnyEntity) -> AnyEntity:
        self.__wire()
        if entity.callback_group is not None:
            entity.callback_group.add_entity(entity)
        entity._part_of = self  # noqa: SLF001  # ours
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
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[MsgType]] = Publisher,
    ) -> Publisher[MsgType]:
        """Create a publisher.

        Args:
            msg_type: Class of the messages.
            topic: Name of the topic; it is expanded and remapped.
            qos_profile: What it offers; a number stands for a history of that depth.
            callback_group: Group of its events' callbacks.
            event_callbacks: Callbacks for its events; None: incompatible QoS is warned of.
            qos_overriding_options: Which policies parameters may override; None: none.
            publisher_class: Class of the publisher.

        Raises:
            NoTypeSupportImportedException: `msg_type` is no message class.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            InvalidQosOverridesError: parameters override it with what can't be.
            UnsupportedEventTypeError: the wire doesn't know an event that there is a callback for.
        """
        check_is_valid_msg_type(msg_type)
        name = self.resolve_topic_name(topic)
        profile = self.__profile("publisher", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        writer = self.__wire().create_writer(self.__node_name, wire_topic, profile.to_wire())
        group = callback_group or self.__default_callback_group
        publisher = publisher_class(writer, msg_type, name, profile, None, group, context=self.__context)
        publisher._part_of = self  # noqa: SLF001  # ours
        self.__publishers.append(publisher)
        try:
            publisher.event_handlers = self.__watch(
                event_callbacks or PublisherEventCallbacks(), group, writer, name
            )
        except BaseException:
            self.destroy_publisher(publisher)
            raise
        return publisher

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
            callback: Takes a message, or a message and a dict of its stamps [ns]. Runs on a thread of the executor.
            qos_profile: What it asks for; a number stands for a history of that depth.
            callback_group: Group of its callbacks; None: the node's own.
            event_callbacks: Callbacks for its events; None: incompatible QoS is warned of.
            qos_overriding_options: Which policies parameters may override; None: none.
            raw: Whether the callback takes bytes, encapsulation header and CDR, rather than messages.

        Raises:
            NoTypeSupportImportedException: `msg_type` is no message class.
            InvalidTopicNameException: the name isn't valid.
            TypeError, ValueError: `qos_profile` is neither a profile nor a depth.
            InvalidQosOverridesError: parameters override it with what can't be.
            RuntimeError: `callback` takes neither one argument nor two.
            UnsupportedEventTypeError: the wire doesn't know an event that there is a callback for.
        """
        check_is_valid_msg_type(msg_type)
        name = self.resolve_topic_name(topic)
        profile = self.__profile("subscription", name, qos_profile, qos_overriding_options)
        wire_topic = topic_of(msg_type, name, is_native=profile.avoid_ros_namespace_conventions)
        reader = self.__wire().create_reader(self.__node_name, wire_topic, profile.to_wire())
        group = callback_group or self.__default_callback_group
        try:
            subscription = Subscription(
                reader, msg_type, name, callback, group, profile, raw, None, logger=self.get_logger()
            )
        except BaseException:
            reader.close()
            raise
        self.__add(subscription)
        try:
            subscription.event_handlers = self.__watch(
                event_callbacks or SubscriptionEventCallbacks(), group, reader, name
            )
        except BaseException:
            self.destroy_subscription(subscription)
            raise
        return subscription

    def __profile(
        self, kind: str, topic_name: str, given: QoSProfile | int, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        profile = _profile(given)
        if options is None or not isinstance(self, NodeParameters):
            return profile
        return apply_overrides(self, kind, topic_name, profile, options)

    def __watch(
        self,
        callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks,
        group: CallbackGroup,
        endpoint: Writer | Reader,
        topic_name: str,
    ) -> list[EventHandler]:
        graph = self.__participant.graph
        handlers = callbacks.create_event_handlers(
            group, endpoint, topic_name, logger=self.get_logger(), graph=graph
        )
        return [self.__add(handler) for handler in handlers]

    def create_service(
        self,
        srv_type: type[ServiceType],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Create a service.

        Args:
            srv_type: Class of the service.
            srv_name: Its name; it is expanded and remapped.
            callback: Takes a request and an empty response, and returns the response, or is a coroutine function
                that does. Runs on a thread of the executor.
            qos_profile: QoS of requests and responses.
            callback_group: Group of its callbacks; None: the node's own.

        Raises:
            NoTypeSupportImportedException: `srv_type` is no service class.
            InvalidServiceNameException: the name isn't valid.
        """
        check_is_valid_srv_type(srv_type)
        name = self.resolve_service_name(srv_name)
        responder = self.__wire().create_responder(
            self.__node_name, service_of(srv_type, name), qos_profile.to_wire()
        )
        group = callback_group or self.__default_callback_group
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
        return self.__add(service)

    def create_client(
        self,
        srv_type: type[ServiceType],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Create a client of a service.

        Args:
            srv_type: Class of the service.
            srv_name: Its name; it is expanded and remapped.
            qos_profile: QoS of requests and responses.
            callback_group: Kept for `rclpy`'s sake: taking in a response waits for no callback.

        Raises:
            NoTypeSupportImportedException: `srv_type` is no service class.
            InvalidServiceNameException: the name isn't valid.
        """
        check_is_valid_srv_type(srv_type)
        name = self.resolve_service_name(srv_name)
        requester = self.__wire().create_requester(
            self.__node_name, service_of(srv_type, name), qos_profile.to_wire()
        )
        client = Client(
            self.__context,
            requester,
            srv_type,
            name,
            qos_profile,
            callback_group or self.__default_callback_group,
            executor=lambda: self.executor,
            introspection=self.__introspection(srv_type, name),
            logger=self.get_logger(),
        )
        return self.__add(client)

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
            callback, group, period_ns, clock or self.get_clock(), context=self.__context, autostart=autostart
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

    def __destroy(self, entity: Entity) -> bool:
        removed = self.__remove(entity)
        if removed:
            entity.destroy()
        return removed

    def destroy_entities(self) -> None:
        """Destroy all that was created."""
        for rate in list(self.__rates):
            self.destroy_rate(rate)
        for entity in reversed(self.entities()):  # what watches a thing stands behind it
            self.__destroy(entity)
        for publisher in list(self.__publishers):
            self.destroy_publisher(publisher)
        for end in self.__unspun:
            end.destroy()
        self.__unspun.clear()
        self.__destroyed = True

    def __unwatch(self, handlers: list[EventHandler]) -> None:
        for handler in handlers:
            self.__destroy(handler)

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher; False if it isn't this node's."""
        if publisher not in self.__publishers:
            return False
        self.__publishers.remove(publisher)
        self.__unwatch(publisher.event_handlers)
        publisher.destroy()
        return True

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription; False if it isn't this node's."""
        self.__unwatch(subscription.event_handlers)
        return self.__destroy(subscription)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service; False if it isn't this node's."""
        return self.__destroy(service)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client; False if it isn't this node's. Its requests get no response any more."""
        return self.__destroy(client)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it isn't this node's."""
        return self.__destroy(timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it isn't this node's."""
        return self.__destroy(guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; False if it isn't this node's."""
        if rate not in self.__rates:
            return False
        self.__rates.remove(rate)
        self.__remove(rate.timer)
        rate.destroy()
        return True


def _profile(qos_profile: QoSProfile | int) -> QoSProfile:
    if isinstance(qos_profile, QoSProfile):
        return qos_profile
    if isinstance(qos_profile, bool) or not isinstance(qos_profile, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_profile)!r}")
    if qos_profile < 0:
        raise ValueError("History depth must be greater than or equal to 0")
    return QoSProfile(depth=qos_profile)
