"""The entities that a node has created, and that are destroyed with it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from tfloom.node.values.exceptions import InvalidHandle

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.node.executing.entity import Entity
    from tfloom.node.executing.executor import SpunNode
    from tfloom.node.executing.timer import Rate
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["OwnedEntities"]

AnyEntity = TypeVar("AnyEntity", bound="Entity")
WireEndpoint = TypeVar("WireEndpoint")


class Destroyable(Protocol):
    """An endpoint that no executor runs."""

    def destroy(self) -> None:
        """Leave the wire."""


class OwnedEntities:
    """The entities of one node, its publishers and rates, and its endpoints that no executor runs.

    Each of them keeps the node alive by its attribute `_part_of`. The lists have no lock, because each change is a
    single operation on a list.

    Args:
        participant: Creates the node's endpoints.
        node_name: The node's name.
        context: The node's context.
    """

    def __init__(self, participant: Participant, node_name: NodeName, context: Context) -> None:
        self._participant = participant
        self._node_name = node_name
        self._context = context
        self._entities: list[Entity] = []
        self._publishers: list[Publisher[Any]] = []
        self._rates: list[Rate] = []
        self._unspun: list[Destroyable] = []
        self._destroyed = False

    @property
    def node_name(self) -> NodeName:
        """The node's name."""
        return self._node_name

    def participant(self) -> Participant:
        """Return the participant that creates endpoints.

        Raises:
            InvalidHandle: the node was destroyed.
            ForkedProcessError: this process is a fork of the one that created the node.
        """
        if self._destroyed:
            raise InvalidHandle(f"cannot create anything for {self._node_name.full}: the node was destroyed")
        self._context.check_not_from_parent_process(f"cannot create anything for {self._node_name.full}")
        return self._participant

    def entities(self) -> list[Entity]:
        """Return all entities that an executor runs."""
        return list(self._entities)

    def publishers(self) -> list[Publisher[Any]]:
        """Return the publishers that are not destroyed."""
        return list(self._publishers)

    def add(self, entity: AnyEntity, owner: SpunNode) -> AnyEntity:
        """Add an entity, also to the executor of its node `owner`.

        Raises:
            InvalidHandle: the node was destroyed.
        """
        self.participant()
        if entity.callback_group is not None:
            entity.callback_group.add_entity(entity)
        entity._part_of = owner  # noqa: SLF001  # ours
        self._entities.append(entity)
        executor = owner.executor
        if executor is not None:
            executor.add_entity(entity)
        return entity

    def remove(self, entity: Entity) -> bool:
        """Remove an entity, also from its node's executor; False if it isn't here."""
        if entity not in self._entities:
            return False
        self._entities.remove(entity)
        executor = entity._part_of.executor  # noqa: SLF001  # ours
        if executor is not None:
            executor.remove_entity(entity)
        return True

    def destroy(self, entity: Entity) -> bool:
        """Remove and destroy an entity; False if it isn't here."""
        removed = self.remove(entity)
        if removed:
            entity.destroy()
        return removed

    def add_publisher(self, publisher: Publisher[Any], owner: SpunNode) -> None:
        """Add a publisher of the node `owner`."""
        publisher._part_of = owner  # noqa: SLF001  # ours
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
        created = create(self.participant(), self._node_name)
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
