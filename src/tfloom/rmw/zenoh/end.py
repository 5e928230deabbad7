"""What all ends on the Zenoh wire have in common, of topics and of services."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from tfloom.common.signals import signals_deferred
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.zenoh.graph import Peer, ZenohGraph
from tfloom.rmw.zenoh.session import refuse_fork
from tfloom.rmw.zenoh.tokens import Kind

__all__ = ["ZenohEnd", "end_declarations"]


class ZenohEnd:
    """A writer, reader, client or server: what Zenoh has of it, its watch on the graph, and its end.

    Args:
        gid: 16 bytes.
        name: Fully qualified name of the topic or service.
        watched_kind: What the graph tells it of.
        graph: The participant's.
        forget: Called with this end when it is closed.
    """

    kind = ""
    """For texts: writer, reader, client or server."""

    def __init__(
        self,
        gid: bytes,
        name: str,
        watched_kind: Kind,
        graph: ZenohGraph,
        forget: Callable[[Any], None],
    ) -> None:
        self.gid = gid
        self.watched_name = name
        self.watched_kind = watched_kind
        self._graph = graph
        self._forget = forget
        self._lock = threading.Lock()
        self._declarations: list[Any] = []
        """What Zenoh has of it, in the order in which it is ended."""
        self._is_closed = False
        self._is_forked = False

    def adopt(self, *declarations: Any) -> None:
        """Take what Zenoh has of this end, in the order in which it is to be ended."""
        self._declarations = list(declarations)

    def add_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a peer; see `graph.Watcher`."""
        raise NotImplementedError

    def remove_peer(self, peer: Peer) -> Callable[[], None] | None:
        """Note a peer that has left; see `graph.Watcher`."""
        raise NotImplementedError

    def _check_process(self) -> None:
        """Check that this process has opened it.

        Raises:
            ForkedError: a parent has.
        """
        if self._is_forked:
            refuse_fork(f"the {self.kind} of {self.watched_name}")

    def _check_open(self, what: str) -> None:
        """Check that it can be used.

        Raises:
            ForkedError: a parent process has opened it.
            ClosedError: it is closed; the text says that it cannot `what`.
        """
        self._check_process()
        if self._is_closed:
            raise ClosedError(f"cannot {what}: the {self.kind} of {self.watched_name} is closed")

    def invalidate_after_fork(self) -> None:
        """Become the copy of the parent's end in a forked child."""
        self._is_forked = True
        self._lock = threading.Lock()

    def close(self) -> None:
        """Leave the topic or service. Closing again does nothing."""
        with self._lock:
            if self._is_closed:
                return
            self._is_closed = True
        if self._is_forked:
            return
        self._graph.unwatch(self)
        end_declarations(self._declarations)
        self._forget(self)


def end_declarations(declarations: list[Any]) -> None:
    """End what Zenoh has of an endpoint, in order. One that the session's end has ended before is not an error."""
    with signals_deferred():
        for declaration in declarations:
            with suppress(Exception):  # a ZError, whose class is loaded with the library
                declaration.undeclare()
