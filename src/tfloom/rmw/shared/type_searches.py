"""Types without a definition here, which are searched for among the nodes that use them."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, NamedTuple

from tfloom._native import ReadyQueue
from tfloom.rmw.shared.peer_types import TypeSearch

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["TypeSearches"]

AGAIN_S = 1.0
"""Least time between the ends of two searches for a type [s]; between, the graph has to have changed, too."""


class _Vain(NamedTuple):
    """A search that has found nothing."""

    end_s: float
    """When it was over [s, monotonic]."""
    changes: int
    """The state of the graph then."""
    reasons: list[str]


class TypeSearches:
    """Searches for types, without waits. One thread may use it.

    Args:
        participant: The participant that asks.
        node: Its node, which was added to the participant.
    """

    def __init__(self, participant: Participant, node: NodeName) -> None:
        self._participant = participant
        self._node = node
        self._arrived = ReadyQueue()
        self._searches: dict[str, TypeSearch] = {}
        self._vain: dict[str, _Vain] = {}

    def reasons(self, type_name: str, kind: str) -> list[str] | None:
        """Return why a type is not found, by its full name and kind (msg, srv); None while it is searched for."""
        if type_name in self._searches:
            return None
        vain = self._vain.get(type_name)
        if vain is not None and (
            vain.changes == self._participant.graph.changes() or time.monotonic() < vain.end_s + AGAIN_S
        ):
            return vain.reasons
        self._searches[type_name] = TypeSearch(self._participant, self._node, type_name, kind, self._arrived)
        return None

    def poll(self) -> set[str]:
        """Search on; return the types of which the search has ended, whether they were found or not."""
        ended = set()
        for type_name, search in list(self._searches.items()):
            if search.step():
                ended.add(type_name)
                search.close()
                del self._searches[type_name]
                self._vain[type_name] = _Vain(
                    time.monotonic(), self._participant.graph.changes(), search.reasons
                )
        return ended

    def close(self) -> None:
        """Leave the nodes that are asked."""
        for search in self._searches.values():
            search.close()
        self._searches.clear()
