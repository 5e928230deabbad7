"""The graph on the Zenoh wire, from the liveliness tokens of all sessions of the domain, this one included.

Tokens come on Zenoh's threads; own ones are added by the participant.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol

from tfloom._native import ReadyQueue
from tfloom.common.signals import signals_deferred
from tfloom.common.terminal import report, shown_part
from tfloom.rmw.base import EndpointInfo, NodeName, ParticipantInfo, ServiceEndInfo, Topic
from tfloom.rmw.postponed_interrupt import uninterrupted_files
from tfloom.rmw.topic_names import type_to_dds
from tfloom.rmw.zenoh.announced import AnnouncedTokens
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.session import refuse_fork
from tfloom.rmw.zenoh.tokens import PREFIX, End, Kind, Token, TokenError, gid_of, parse_token, token_pattern

__all__ = ["Peer", "Watcher", "ZenohGraph", "peer_name"]

MAX_TOKENS = 200_000
"""How many tokens are kept; further ones are ignored, which a line tells once."""
MAX_KEY_LENGTH = 4096
"""The longest token that is read [characters]."""

_TOPIC_KINDS = {Kind.PUBLISHER, Kind.SUBSCRIPTION}
_SERVICE_KINDS = {Kind.SERVER, Kind.CLIENT}


class Peer(Protocol):
    """What a watcher learns of an entity of another session, or of its own."""

    gid: bytes
    token: Token
    end: End


class _Entity:
    """A node or an endpoint, with its gid."""

    __slots__ = ("end", "gid", "token")

    def __init__(self, key: str, token: Token) -> None:
        self.gid = gid_of(key)
        self.token = token
        self.end: Any = token.end


class Watcher(Protocol):
    """An own endpoint, which is notified of its topic's other endpoints.

    `add_peer` and `remove_peer` are called with the graph's lock held, so they take their own lock and post, no more.
    """

    watched_name: str
    watched_kind: Kind

    def add_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a peer that has come; return what is to be called without the lock, if anything."""

    def remove_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a peer that has left; return what is to be called without the lock, if anything."""


class ZenohGraph:
    """All that a session has discovered; see `base.Graph`.

    Args:
        session: The `zenoh.Session`.
        domain_id: The domain.
        zid: The session's id.
        open_client: Opens a second session, as a client of the router; see `AnnouncedTokens`. None: there is none, or
            it is this process's own.
    """

    def __init__(
        self,
        session: Any,
        domain_id: int,
        zid: str,
        *,
        open_client: Callable[[], Any] | None = None,
    ) -> None:
        self.zid = zid
        self._announced = open_client and AnnouncedTokens(open_client, token_pattern(domain_id))
        self._own_prefix = f"{PREFIX}/{domain_id}/{zid}/"
        self._lock = threading.Lock()
        self._entities: dict[str, _Entity] = {}
        self._watchers: dict[tuple[str, Kind], list[Watcher]] = {}
        self._listener: tuple[ReadyQueue, int] | None = None
        self._changes = 0
        self._is_overflow_told = False
        self._is_forked = False
        zenoh = open_library()
        self._put = zenoh.SampleKind.PUT
        callback = zenoh.handlers.Callback(self._on_token, indirect=False)
        with signals_deferred():
            self._subscriber = session.liveliness().declare_subscriber(
                token_pattern(domain_id), callback, history=True
            )

    def _on_token(self, sample: Any) -> None:
        key = str(sample.key_expr)
        # The own tokens are known by `add_own`. Zenoh reports their end, too, when a client loses its router.
        if key.startswith(self._own_prefix):
            return
        if sample.kind == self._put:
            self._add(key)
        else:
            self._remove(key)

    def add_own(self, key: str) -> None:
        """Add an own token, which has been declared."""
        self._add(key)

    def remove_own(self, key: str) -> None:
        """Remove an own token."""
        self._remove(key)

    def _add(self, key: str) -> None:
        # After a reconnection all tokens of that link come again, with no deletion before: a known one changes nothing.
        if key in self._entities or (token := self._parsed(key)) is None:
            return
        entity = _Entity(key, token)
        with self._lock:
            if key in self._entities:
                return
            afterwards: list[Callable[[], None] | None] = []
            if len(self._entities) < MAX_TOKENS:
                self._entities[key] = entity
                afterwards += [watcher.add_peer(entity) for watcher in self._watchers_of(entity)]
                self._post_change()
            elif not self._is_overflow_told:
                self._is_overflow_told = True
                afterwards.append(_report_overflow)
        for call in filter(None, afterwards):
            call()

    @staticmethod
    def _parsed(key: str) -> Token | None:
        """Return the token of a key; None if it has another form."""
        try:
            return parse_token(key) if len(key) <= MAX_KEY_LENGTH else None
        except TokenError:
            return None

    def _remove(self, key: str) -> None:
        with self._lock:
            entity = self._entities.pop(key, None)
            if entity is None:
                return
            afterwards = [watcher.remove_peer(entity) for watcher in self._watchers_of(entity)]
            self._post_change()
        for call in filter(None, afterwards):
            call()

    def _watchers_of(self, entity: _Entity) -> list[Watcher]:
        if entity.end is None:
            return []
        return list(self._watchers.get((entity.end.name, entity.token.kind), ()))

    def _post_change(self) -> None:
        self._changes += 1
        if self._listener is not None:
            self._listener[0].post(self._listener[1])

    def watch(self, watcher: Watcher) -> None:
        """Tell an own endpoint of its peers, present and future."""
        key = (watcher.watched_name, watcher.watched_kind)
        with self._lock:
            self._watchers.setdefault(key, []).append(watcher)
            peers = [
                entity
                for entity in self._entities.values()
                if entity.end is not None and (entity.end.name, entity.token.kind) == key
            ]
            afterwards = [watcher.add_peer(peer) for peer in peers]
        for call in filter(None, afterwards):
            call()

    def unwatch(self, watcher: Watcher) -> None:
        """Tell an endpoint that closes of nothing more."""
        if self._is_forked:
            return
        key = (watcher.watched_name, watcher.watched_kind)
        with self._lock:
            watchers = self._watchers.get(key, [])
            if watcher in watchers:
                watchers.remove(watcher)
            if not watchers:
                self._watchers.pop(key, None)

    def _snapshot(self, kinds: set[Kind]) -> list[_Entity]:
        if self._is_forked:
            refuse_fork("the graph")
        with self._lock:
            return [entity for entity in self._entities.values() if entity.token.kind in kinds]

    def nodes(self) -> list[NodeName]:
        """Return the nodes, one entry for each, in order of their full names."""
        return [node for node, _ in self.enclaves()]

    def enclaves(self) -> list[tuple[NodeName, str]]:
        """Return the nodes as `nodes` does, each with the enclave it is in."""
        nodes = [(entity.token.node, entity.token.enclave) for entity in self._snapshot({Kind.NODE})]
        return sorted(nodes, key=lambda node: node[0].full)

    def endpoints(self) -> list[EndpointInfo]:
        """Return writers and readers of ROS topics, in order of topic name."""
        return [info for info in self._infos() if not info.topic.is_native]

    def raw_endpoints(self) -> list[EndpointInfo]:
        """Return all writers and readers, with the types as they are in keys, in order of topic name."""
        return [info._replace(topic=_on_wire(info.topic)) for info in self._infos()]

    def _infos(self) -> list[EndpointInfo]:
        infos = []
        for entity in self._snapshot(_TOPIC_KINDS):
            end = entity.end
            topic = Topic(end.name, end.type_name, end.type_hash, is_native=not end.name.startswith("/"))
            is_writer = entity.token.kind is Kind.PUBLISHER
            infos.append(EndpointInfo(topic, entity.token.node, is_writer, entity.gid, end.qos))
        return sorted(infos, key=lambda info: info.topic.name)

    def service_ends(self) -> list[ServiceEndInfo]:
        """Return servers and clients, in order of service name."""
        ends = [
            ServiceEndInfo(
                entity.end.name,
                entity.end.type_name,
                entity.token.node,
                is_server=entity.token.kind is Kind.SERVER,
                gid=entity.gid,
                qos=entity.end.qos,
                type_hash=entity.end.type_hash,
            )
            for entity in self._snapshot(_SERVICE_KINDS)
        ]
        return sorted(ends, key=lambda end: end.name)

    def participants(self) -> list[ParticipantInfo]:
        """Return the sessions with a token, this one included, in order of their gids: their ids, padded with zeros."""
        nodes: dict[str, list[NodeName]] = {self.zid: []}
        for entity in self._snapshot(set(Kind)):
            names = nodes.setdefault(entity.token.zid, [])
            if entity.token.kind is Kind.NODE:
                names.append(entity.token.node)
        return sorted(
            ParticipantInfo(_gid_of_session(zid), names, zid == self.zid) for zid, names in nodes.items()
        )

    def notify(self, queue: ReadyQueue | None, token: int = 0) -> None:
        """Post `token` to `queue` whenever the graph has changed; None ends it."""
        if self._is_forked and queue is not None:
            refuse_fork("the graph")
        self._listener = None if queue is None else (queue, token)

    def changes(self) -> int:
        """Return a number that grows with each change."""
        return self._changes

    def is_whole(self) -> bool:
        """Return whether all tokens that the router has have come. The first call begins to ask it, and returns False.

        Where the router is this process's own, there are no others, as a rule.
        """
        return self._announced is None or self._announced.are_here(self._lacks)

    def _lacks(self, key: str) -> bool:
        """Return whether a token is to come: it isn't here, and would be kept."""
        if key in self._entities or key.startswith(self._own_prefix) or len(self._entities) >= MAX_TOKENS:
            return False
        return self._parsed(key) is not None

    def delivers_incompatible(self) -> bool:
        """Return True: keys connect endpoints, and they tell nothing of qualities."""
        return True

    def late_count(self) -> int:
        """Return 0: there is no implementation that lists its nodes later."""
        return 0

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's graph in a forked child."""
        self._is_forked = True
        self._lock = threading.Lock()

    def close(self) -> None:
        """Stop listening."""
        if self._announced is not None:
            self._announced.close()
        with signals_deferred(), suppress(Exception):  # a ZError: the session has ended before
            self._subscriber.undeclare()


def peer_name(peer: Peer) -> str:
    """Return the name of a peer's node for texts, in which nothing is what a terminal would obey."""
    return shown_part(peer.token.node.full)


def _report_overflow() -> None:
    """Print that tokens are ignored from now on."""
    report(
        f"tfloom: this domain has more than {MAX_TOKENS} nodes, publishers, subscriptions, servers and clients: "
        "further ones are neither listed nor matched in this program; use more domains (ROS_DOMAIN_ID), and start it "
        "again"
    )


def _on_wire(topic: Topic) -> Topic:
    try:
        return topic._replace(type_name=type_to_dds(topic.type_name))
    except ValueError:  # another program's, in its own form
        return topic


def _gid_of_session(zid: str) -> bytes:
    try:
        return bytes.fromhex(zid.zfill(32))[:16]
    except ValueError:  # a token with an id that is none
        return zid.encode()[:16].ljust(16, b"\0")


uninterrupted_files.add(ZenohGraph.add_own.__code__.co_filename)
