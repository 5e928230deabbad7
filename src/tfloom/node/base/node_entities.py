"""A node as the owner of its entities, which an executor runs and which are destroyed with the node."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

from tfloom.node.base.node_graph import NodeGraph
from tfloom.node.endpoints.client import Client
from tfloom.node.endpoints.service import Service
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.executing.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from tfloom.node.executing.event_handler import EventHandler
from tfloom.node.executing.guard_condition import GuardCondition
from tfloom.node.executing.timer import Rate, Timer
from tfloom.node.executing.waitable_entity import WaitableEntity
from tfloom.node.values.handle import Handle
from tfloom.node.values.set_by_init import SET_BY_INIT

if TYPE_CHECKING:
    from tfloom.node.base.node_names import NodeNames
    from tfloom.node.base.owned_entities import Destroyable, OwnedEntities
    from tfloom.node.clock.clock import Clock
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.node.executing.entity import Entity
    from tfloom.node.executing.executor import Executor
    from tfloom.node.executing.waitable import Waitable
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import Graph, NodeName, Participant

__all__ = ["NodeEntities"]

WireEndpoint = TypeVar("WireEndpoint")


class NodeEntities(NodeGraph):
    """Lists and destroys the entities that a node has created; a base of Node.

    Args:
        names: The node's names.
        graph: Graph of its participant.
        context: The context that it has joined, and leaves when it is destroyed.
        clock: Its clock.
        logger: Its logger.
        owned: The entities that it has created.
    """

    __context: Context = SET_BY_INIT
    __clock: Clock = SET_BY_INIT
    __logger: RcutilsLogger = SET_BY_INIT
    __owned: OwnedEntities = SET_BY_INIT
    __executor: weakref.ref[Executor] | None = SET_BY_INIT
    __default_callback_group: CallbackGroup = SET_BY_INIT
    __destroyed: bool = SET_BY_INIT

    def __init__(
        self,
        names: NodeNames,
        graph: Graph,
        *,
        context: Context,
        clock: Clock,
        logger: RcutilsLogger,
        owned: OwnedEntities,
    ) -> None:
        NodeGraph.__init__(self, names, graph)
        self.__context = context
        self.__clock = clock
        self.__logger = logger
        self.__owned = owned
        self.__executor = None
        self.__default_callback_group = MutuallyExclusiveCallbackGroup()
        self.__destroyed = False

    @property
    def context(self) -> Context:
        """The context it belongs to."""
        return self.__context

    @property
    def handle(self) -> Handle:
        """Proxy of the node, for code that expects rclpy's C handle."""
        return Handle(self)

    @property
    def executor(self) -> Executor | None:
        """The executor that it was added to, or None."""
        return None if self.__executor is None else self.__executor()

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        if new_executor is not None:
            new_executor.add_node(self)
        elif (current := self.executor) is not None:
            current.remove_node(self)

    def _enter_executor(self, executor: Executor | None) -> None:
        """As in `SpunNode`; the setter of `executor` asks the executor, which calls this."""
        former = self.executor
        self.__executor = None if executor is None else weakref.ref(executor)
        if executor is not None and former is not None and former is not executor:
            former.remove_node(self)

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""
        return self.__logger

    def get_clock(self) -> Clock:
        """Return its clock: ROS time."""
        return self.__clock

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of all entities created without one: one callback at a time."""
        return self.__default_callback_group

    def entities(self) -> list[Entity]:
        """Return all entities that an executor runs."""
        return self.__owned.entities()

    @property
    def publishers(self) -> Iterator[Publisher[Any]]:
        """The publishers that the node created."""
        return iter(self.__owned.publishers())

    @property
    def subscriptions(self) -> Iterator[Subscription[Any]]:
        """The subscriptions that the node created."""
        return (entity for entity in self.entities() if isinstance(entity, Subscription))

    @property
    def services(self) -> Iterator[Service]:
        """The services that the node created."""
        return (entity for entity in self.entities() if isinstance(entity, Service))

    @property
    def clients(self) -> Iterator[Client]:
        """The clients that the node created."""
        return (entity for entity in self.entities() if isinstance(entity, Client))

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers that the node created."""
        return (entity for entity in self.entities() if isinstance(entity, Timer))

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions that the node created."""
        return (entity for entity in self.entities() if isinstance(entity, GuardCondition))

    @property
    def waitables(self) -> Iterator[Waitable]:
        """The waitables that were added."""
        return (entity.waitable for entity in self.entities() if isinstance(entity, WaitableEntity))

    def add_waitable(self, waitable: Waitable | EventHandler) -> None:
        """Add a waitable, or an event handler, to those that the node's executor waits for."""
        if isinstance(waitable, EventHandler):
            self.__owned.add(waitable, self)
        else:
            self.__owned.add(WaitableEntity(waitable, lambda: self.executor), self)

    def remove_waitable(self, waitable: Waitable | EventHandler) -> None:
        """Undo `add_waitable`.

        Raises:
            ValueError: it was never added.
        """
        for entity in self.entities():
            if entity is waitable or (isinstance(entity, WaitableEntity) and entity.waitable is waitable):
                self.__owned.destroy(entity)
                return
        raise ValueError(f"{waitable!r} is no waitable of this node")

    def _open(
        self, endpoint: Destroyable, create: Callable[[Participant, NodeName], WireEndpoint]
    ) -> WireEndpoint:
        """Return what `create` makes on the wire for `endpoint`, which no executor runs; see `OwnedEntities.open`."""
        return self.__owned.open(endpoint, create)

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher; False if it isn't this node's."""
        return self.__owned.destroy_publisher(publisher)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription; False if it isn't this node's."""
        for handler in subscription.event_handlers:
            self.__owned.destroy(handler)
        return self.__owned.destroy(subscription)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service; False if it isn't this node's."""
        return self.__owned.destroy(service)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client; False if it isn't this node's. Its pending requests are cancelled."""
        self.__owned.destroy(client.server_watch)
        return self.__owned.destroy(client)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it isn't this node's."""
        return self.__owned.destroy(timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it isn't this node's."""
        return self.__owned.destroy(guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; False if it isn't this node's."""
        return self.__owned.destroy_rate(rate)

    def destroy_entities(self) -> None:
        """Destroy all that was created."""
        self.__owned.destroy_all()

    def destroy_node(self) -> None:
        """Leave the executor and the graph, and destroy all that was created. Destroying again does nothing."""
        if self.__destroyed:
            return
        self.__destroyed = True
        self.executor = None
        self.destroy_entities()
        self.__context.leave(self.__owned.node_name)

    def __del__(self) -> None:
        if not getattr(self, "_NodeEntities__destroyed", True):
            self.__context.abandon(self)
