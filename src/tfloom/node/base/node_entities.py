"""What a node has created: the entities that its executor runs, and all that is destroyed with the node."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from tfloom.node.endpoints.endpoint import Endpoint
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.executing.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from tfloom.node.executing.event_handler import report_other_type
from tfloom.node.values.exceptions import InvalidHandle

if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.executing.entity import Entity
    from tfloom.node.executing.event_handler import (
        EventHandler,
        PublisherEventCallbacks,
        SubscriptionEventCallbacks,
    )
    from tfloom.node.executing.executor import Executor, SpunNode
    from tfloom.node.executing.timer import Rate
    from tfloom.node.log.rcutils_logger import RcutilsLogger
    from tfloom.rmw.base import NodeName, Participant, Reader, Topic, Writer

__all__ = ["NodeEntities"]

AnyEntity = TypeVar("AnyEntity", bound="Entity")
WireEndpoint = TypeVar("WireEndpoint")


class Destroyable(Protocol):
    """An endpoint that no executor runs."""

    def destroy(self) -> None:
        """Leave the wire."""


class NodeEntities:
    """The entities of one node, its publishers and rates, and its endpoints that no executor runs.

    Each of them keeps the node alive by its attribute `owner`. The lists have no lock, because each change is a
    single operation on a list.

    Args:
        owner: The node.
        participant: Creates the node's endpoints.
        node_name: The node's name.
        context: The context that the node has joined.
        clock: The node's clock.
        logger: The node's logger.
    """

    def __init__(
        self,
        owner: SpunNode,
        participant: Participant,
        node_name: NodeName,
        *,
        context: Context,
        clock: Clock,
        logger: RcutilsLogger,
    ) -> None:
        self._owner = owner
        self._participant = participant
        self.node_name = node_name
        self.context = context
        self.clock = clock
        self.logger = logger
        self.default_callback_group: CallbackGroup = MutuallyExclusiveCallbackGroup()
        """The group of all entities that are created without one."""
        self.has_left = False
        """Whether the node has left the graph."""
        self._executor: weakref.ref[Executor] | None = None
        self._last_executor: weakref.ref[Executor] | None = None
        self._entities: list[Entity] = []
        self._publishers: list[Publisher[Any]] = []
        self._rates: list[Rate] = []
        self._unspun: list[Destroyable] = []
        self._destroyed = False

    @property
    def executor(self) -> Executor | None:
        """The executor that runs the entities."""
        return None if self._executor is None else self._executor()

    @executor.setter
    def executor(self, executor: Executor | None) -> None:
        self._executor = None if executor is None else weakref.ref(executor)
        if executor is not None:
            self.last_executor = executor

    @property
    def last_executor(self) -> Executor | None:
        """The executor that runs the entities, or the one that ran them last; it may be one of a program's own."""
        return None if self._last_executor is None else self._last_executor()

    @last_executor.setter
    def last_executor(self, executor: Executor | None) -> None:
        self._last_executor = None if executor is None else weakref.ref(executor)

    def participant(self) -> Participant:
        """Return the participant that creates endpoints.

        Raises:
            InvalidHandle: the node was destroyed.
            ForkedProcessError: this process is a fork of the one that created the node.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot create anything for {self.node_name.full}: the node was destroyed")
        self._check_not_forked()
        return self._participant

    def _check_not_forked(self) -> None:
        self.context.check_not_from_parent_process(f"cannot create anything for {self.node_name.full}")

    def entities(self) -> list[Entity]:
        """Return all entities that an executor runs."""
        return list(self._entities)

    def publishers(self) -> list[Publisher[Any]]:
        """Return the publishers that are not destroyed."""
        return list(self._publishers)

    def add(self, entity: AnyEntity) -> AnyEntity:
        """Add an entity, also to the node's executor.

        Raises:
            InvalidHandle: the node was destroyed, and the entity has an endpoint.
            ForkedProcessError: this process is a fork of the one that created the node.
        """
        if isinstance(entity, Endpoint):
            self.participant()
        self._check_not_forked()
        if entity.callback_group is not None:
            entity.callback_group.add_entity(entity.member)
        entity.owner, entity.on_destroy = self._owner, self.destroy
        self._entities.append(entity)
        executor = self.executor
        if executor is not None:
            executor.add_entity(entity)
        return entity

    def remove(self, entity: Entity) -> bool:
        """Remove an entity, also from the node's executor; False if it isn't here."""
        if entity not in self._entities:
            return False
        self._entities.remove(entity)
        executor = self.executor
        if executor is not None:
            executor.remove_entity(entity)
        return True

    def destroy(self, entity: Entity) -> bool:
        """Remove and destroy an entity and what belongs to it; False if it isn't here."""
        removed = self.remove(entity)
        if removed:
            for other in entity.belongings():
                self.destroy(other)
            entity.destroy()
        return removed

    def add_publisher(self, publisher: Publisher[Any]) -> None:
        """Add a publisher."""
        publisher.owner, publisher.on_destroy = self._owner, self.destroy_publisher
        self._publishers.append(publisher)

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Remove and destroy a publisher and its event handlers; False if it isn't here."""
        if publisher not in self._publishers:
            return False
        self._publishers.remove(publisher)
        for handler in publisher.event_handlers:
            self.destroy(handler)
        publisher.destroy()
        return True

    def watch(
        self,
        callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks,
        group: CallbackGroup,
        endpoint: Writer | Reader,
        topic_name: str,
    ) -> list[EventHandler]:
        """Add handlers of the events of an endpoint on the wire, and return them."""
        handlers = callbacks.create_event_handlers(
            group, endpoint, topic_name, logger=self.logger, graph=self.participant().graph
        )
        return [self.add(handler) for handler in handlers]

    def warn_of_other_type(self, topic: Topic, endpoint: Publisher[Any] | Subscription[Any]) -> None:
        """Log a warning if an endpoint of this program has the topic with another type, and report it to both.

        The warning is logged at once, because a program that has mistaken a type may never spin.
        """
        others = self.context.topic_types.add(topic, endpoint)
        if others:
            other_type = others[0].msg_type._TYPE_NAME  # ours
            warning = (
                f"{topic.name} has two types in this program: {other_type}, and here {topic.type_name}. Messages "
                "pass only between endpoints of one type"
            )
            self.logger.warning(warning)
        for other in others:
            if isinstance(other, Publisher) != isinstance(endpoint, Publisher):
                report_other_type(other.event_handlers)
                report_other_type(endpoint.event_handlers)

    def add_rate(self, rate: Rate) -> None:
        """Add a rate, which is destroyed with the node."""
        self._rates.append(rate)

    def destroy_rate(self, rate: Rate) -> bool:
        """Remove and destroy a rate; False if it isn't here."""
        if rate not in self._rates:
            return False
        self._rates.remove(rate)
        self.remove(rate.timer)
        rate.destroy()
        return True

    def open(
        self, endpoint: Destroyable, create: Callable[[Participant, NodeName], WireEndpoint]
    ) -> WireEndpoint:
        """Return what `create` makes on the wire for `endpoint`, which is destroyed with the node.

        Raises:
            InvalidHandle: the node was destroyed.
        """
        created = create(self.participant(), self.node_name)
        self._unspun.append(endpoint)
        return created

    def destroy_all(self) -> None:
        """Destroy everything, the newest first; creating more raises InvalidHandle."""
        for rate in list(self._rates):
            self.destroy_rate(rate)
        for entity in reversed(self.entities()):  # event handlers come after the endpoints that they watch
            self.destroy(entity)
        for publisher in list(self._publishers):
            self.destroy_publisher(publisher)
        for endpoint in reversed(self._unspun):
            endpoint.destroy()
        self._unspun.clear()
        self._destroyed = True
