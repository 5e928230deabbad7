"""Types that have no definition here, from the nodes that use them: by the service `~/get_type_description`.

A `TypeSearch` is for one type, and `TypeSearches` for those of a program.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import NamedTuple

from tfloom._native import ReadyQueue
from tfloom.interfaces.type_description_interfaces.srv import GetTypeDescription, GetTypeDescription_Response
from tfloom.rmw.base import Graph, NodeName, Participant
from tfloom.rmw.errors import WireError
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rmw.topic_names import type_from_dds
from tfloom.rosidl import cdr
from tfloom.rosidl.described import ANNOUNCED, ANNOUNCED_WITH_SERVICES, DescriptionError, define_described

__all__ = ["TypeSearch", "TypeSearches", "learn", "users"]

CALL_S = 2.0
"""How long to wait for the service of a node, and again for its response [s]."""
PATIENCE_S = 3.0
"""How long to wait for a node that uses a type, while discovery is not complete [s]: as long as Fast DDS may take."""
MAX_NODES = 3
"""How many nodes are asked at most."""
LOOK_S = 0.05
"""Period at which a search that is waited for is looked at [s]; what arrives ends the sleep."""
AGAIN_S = 1.0
"""Least time between the ends of two searches for a type [s]; between, the graph has to have changed, too."""


class TypeSearch:
    """Makes the classes of a type from the description of a node that uses it, in steps that never wait.

    One thread may use it.

    Args:
        participant: The participant that asks.
        own_node: Its node, which was added to the participant.
        name: `package/kind/Name`.
        kind: msg, srv or action.
        arrived: Gets a token when a response may have arrived.
        patience_s: How long to wait for a node that uses the type, while discovery is not complete [s].
    """

    def __init__(
        self,
        participant: Participant,
        own_node: NodeName,
        name: str,
        kind: str,
        arrived: ReadyQueue,
        *,
        patience_s: float = PATIENCE_S,
    ) -> None:
        self.reasons: list[str] = []
        """Why the descriptions of nodes can't be used: empty after success, and where no node uses the type."""
        self._participant = participant
        self._own_node = own_node
        self._name = name
        self._kind = kind
        self._arrived = arrived
        self._users: list[tuple[NodeName, dict[str, str]]] | None = None
        """The nodes that are still to be asked; None until they are known."""
        self._end_s = time.monotonic() + patience_s
        self._asked: tuple[ServiceRequest, NodeName, Mapping[str, str]] | None = None

    def step(self) -> bool:
        """Do what can be done now; return whether the search is over."""
        if self._users is None:
            graph = self._participant.graph
            known = users(graph, self._name, self._kind)
            # An endpoint may be known before its node is.
            if not known and not graph.is_whole() and time.monotonic() < self._end_s:
                return False
            self._users = list(known.items())[:MAX_NODES]
        while True:
            if self._asked is None:
                if not self._users:
                    return True
                node, hashes = self._users.pop(0)
                try:
                    self._ask(node, hashes)
                except WireError as error:
                    self.reasons.append(str(error))
                    continue
            reason = self._answer()
            if reason is None:
                return False
            self.close()
            if not reason:
                self.reasons.clear()
                self._users.clear()
                return True
            self.reasons.append(reason)

    def _ask(self, node: NodeName, hashes: Mapping[str, str]) -> None:
        """Ask a node for its description of the type.

        Args:
            node: The node.
            hashes: What it announced. The hash of the type itself is missing where its parts alone have hashes.

        Raises:
            WireError: the wire refuses a client.
        """
        name = f"{node.full}/get_type_description"
        asked = ServiceRequest(self._participant, self._own_node, name, GetTypeDescription, self._arrived)
        self._asked = asked, node, hashes
        request = GetTypeDescription.Request(
            type_name=self._name, type_hash=hashes.get(self._name, ""), include_type_sources=False
        )
        asked.ask(cdr.encode(request), response_s=CALL_S, server_s=CALL_S)

    def _answer(self) -> str | None:
        """Make the classes from the answer; return why not, empty after success, None while there is no answer."""
        if self._asked is None:  # `step` asks first
            return None
        asked, node, hashes = self._asked
        try:
            response: GetTypeDescription_Response | None = asked.take()
            if response is None:
                return None
            if not response.successful:
                return f"{node.full} has no description of it: {response.failure_reason}"
            define_described(self._name, response.type_description, hashes)
        except (ServiceRequestError, WireError) as error:
            return str(error)
        except DescriptionError as error:
            return f"the description from {node.full} can't be used: {error}"
        return ""

    def close(self) -> None:
        """Leave the node that is asked."""
        if self._asked is not None:
            self._asked[0].close()
            self._asked = None


def learn(participant: Participant, own_node: NodeName, name: str, kind: str) -> list[str]:
    """Search for a type until that is over, where discovery is complete; arguments as of `TypeSearch`.

    Returns:
        Why the descriptions of nodes can't be used: empty after success, and where no node uses the type.
    """
    arrived = ReadyQueue()
    search = TypeSearch(participant, own_node, name, kind, arrived, patience_s=0.0)
    try:
        while not search.step():
            arrived.wait(int(LOOK_S * 1e9))
    finally:
        search.close()
    return search.reasons


def users(found: Graph, name: str, kind: str) -> dict[NodeName, dict[str, str]]:
    """Return the nodes that announce the hashes of a type, with the hashes of its parts by their names."""
    forms = [{name + suffix for suffix in form[kind]} for form in (ANNOUNCED, ANNOUNCED_WITH_SERVICES)]
    announced: dict[NodeName, dict[str, str]] = {}

    def note(node: NodeName | None, part: str, type_hash: str) -> None:
        if node is not None and type_hash and any(part in form for form in forms):
            announced.setdefault(node, {})[part] = type_hash

    for end in found.raw_endpoints():
        note(end.node, type_from_dds(end.topic.type_name), end.topic.type_hash)
    for service_end in found.service_ends():
        note(service_end.node, service_end.type_name, service_end.type_hash)
    return {node: hashes for node, hashes in announced.items() if hashes.keys() in forms}


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
