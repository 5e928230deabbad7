"""The meeting point of one machine: a router inside one of its processes, where none is running.

Two peers of Zenoh discover each other through a router. So each session tries to open one at the agreed port; the
kernel gives the port to one process. When that one ends, the others lose their link, and one of them has the port next.
Peers have their own links, so data that flows between them goes on meanwhile.

A router in a separate process takes precedence: when it starts and finds the port taken, it asks the sessions of this
machine to give way. They answer, close their router, and leave the port alone for some seconds.

A router that is linked to those of other machines takes the place of another one late, by `LINK_GAP_S`.
"""

from __future__ import annotations

import re
import socket
import threading
import time
from contextlib import closing, suppress
from typing import Any

from tfloom.common.terminal import report
from tfloom.rmw.errors import WireError
from tfloom.rmw.zenoh.config import (
    default_configuration,
    endpoints_of,
    meeting_point_configuration,
    port,
    reason_of,
    session_settings,
)
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.port_holder import end_connections, find_port_owner
from tfloom.rmw.zenoh.router import open_router, open_where_free

__all__ = ["MeetingPoint", "open_lone_router"]

PERIOD_S = 0.2
"""How often a session looks whether it still has a router [s]."""
NO_ANSWER_S = 3.0
"""How long a silent router is tolerated before it is reported [s]: after a change of owner, sessions retry for 1 s."""
GIVE_WAY_S = 3.0
"""How long sessions leave the port alone after a router has asked for it [s]."""
REPLY_S = 0.1
"""How long the owner's router goes on after the request, to carry the replies [s]."""
ASK_TIMEOUT_S = 2.0
LEAVE_S = 1.0
"""How long the owner takes to close its router after a request, at most, before it is asked again [s]."""
TAKEOVER_S = 10.0
"""How long a router asks for the port again while others have it [s]."""
LINK_GAP_S = 0.5
"""How long after the end of this machine's router the next one is opened, where it is linked to other machines [s].

Zenoh's routers look at what has changed between them each 100 ms at most, and know each other by numbers that are used
again. Where one leaves and the next one is linked between two looks, the others see no change: it never gets their
tokens, subscriptions and services, and nothing can ask for them. The rest is for a busy machine.
"""


class MeetingPoint:
    """A session's part in the meeting point of the machine: it has the router, or takes over where nobody has it.

    A separate thread does so. The lock guards the router: opened by that thread or by the constructor, closed by
    `close`.

    Raises:
        WireError: a router can't be opened at this port, for another reason than that it is taken.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._router: Any = None
        self._port = 0
        """The port of the router that was opened last."""
        self._is_closed = threading.Event()
        self._thread: threading.Thread | None = None
        self._is_reported = False
        self._asked_at: float | None = None
        """When a router asked for the port [s]; set by Zenoh's thread, read by the own one."""
        self._routers_when_asked: set[str] | None = None
        """Ids of the routers that the session was linked to then; None until the own thread has looked."""
        self._queryable: Any = None
        self._takeover_s = 0.0
        """How long no router is seen before this one takes over [s]."""
        self._open_router()

    @property
    def is_owner(self) -> bool:
        """Whether the router is in this process, opened by this object."""
        with self._lock:
            return self._router is not None

    def watch(self, session: Any) -> None:
        """Take over the router, from a thread, whenever a `zenoh.Session` has none and its port is free.

        Raises:
            RuntimeError: the system has no thread.
        """
        zenoh = open_library()
        self._queryable = session.declare_queryable(
            _give_way_key(), zenoh.handlers.Callback(self._on_request, indirect=False), complete=True
        )
        self._thread = threading.Thread(
            target=self._watch, args=(session,), name="tfloom_meeting_point", daemon=True
        )
        try:
            self._thread.start()
        except RuntimeError:
            self._thread = None
            raise

    def close(self) -> None:
        """End the thread, then the router. Another process takes over. Close the session before."""
        self._is_closed.set()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join()
        self._close_router()

    def report_silence(self) -> None:
        """Print, once until the router answers, that it doesn't, and which process holds its port."""
        if self._is_reported:
            return
        self._is_reported = True
        where = f"127.0.0.1:{port()}"
        owner = find_port_owner(port())
        if owner is None:
            text = f"no answer from the router on {where}, held by a process that is stopped?"
        else:
            text = f"no answer from the router on {where}, held by {owner}"
        report(f"tfloom: {text}: until it goes on or ends, new programs don't discover each other")

    def _open_router(self) -> None:
        self._port = port()
        config = meeting_point_configuration()
        if _links_routers(config):
            self._takeover_s = LINK_GAP_S
        router = open_where_free(config)
        with self._lock:
            self._router = router

    def _close_router(self) -> None:
        with self._lock:
            router, self._router = self._router, None
        if router is not None:
            try:
                router.close()
            except open_library().ZError as error:  # as where a program that is linked takes nothing
                report(f"tfloom: the Zenoh router of this process can't be closed: {reason_of(error)}")
            # A link that is accepted while the router closes stays open in the library: who has it would take it for
            # that of a router, and never be linked to the next one.
            end_connections(self._port)

    def _on_request(self, query: Any) -> None:
        """Note that a router asks for the port; called on a thread of Zenoh, which must not close a session."""
        self._routers_when_asked = None
        self._asked_at = time.monotonic()
        query.reply(query.key_expr, b"")
        query.drop()

    def _gives_way(self, routers: set[str]) -> bool:
        """Return whether the port is to be left to a router that asked; close the own one then.

        Args:
            routers: Ids of the routers that the session is linked to. A new one is the one that asked, as a rule; where
                another session was faster, it asks again.
        """
        if self._asked_at is None:
            return False
        if self._routers_when_asked is None:
            self._routers_when_asked = routers
        since_s = time.monotonic() - self._asked_at
        if since_s > GIVE_WAY_S or routers - self._routers_when_asked:
            self._asked_at = None
            return False
        if since_s > REPLY_S:
            self._close_router()
        return True

    def _watch(self, session: Any) -> None:
        silent_since: float | None = None  # the first look that found no router
        while not self._is_closed.wait(PERIOD_S):
            try:
                routers = {str(zid) for zid in session.info.routers_zid()}
            except Exception:  # the session was closed by other means: there is nothing to watch
                return
            if self._gives_way(routers):
                silent_since = None
                continue
            if routers:
                silent_since = None
                self._is_reported = False
                continue
            now = time.monotonic()
            if silent_since is None:
                silent_since = now
            if not self.is_owner and now - silent_since >= self._takeover_s:
                # A failure other than a taken port, as a lack of descriptors, may pass: the next round tries again.
                with suppress(WireError):
                    self._open_router()
            if not self.is_owner and now - silent_since > NO_ANSWER_S:
                self.report_silence()


def open_lone_router(config: Any) -> Any:
    """Open a router for a separate process; if a session of this machine has its port, take it over from that one.

    Args:
        config: A `zenoh.Config` with the mode `router`.

    Returns:
        The `zenoh.Session`, which must be closed.

    Raises:
        RouterError: it can't listen, as where another program or router has the port.
    """
    gap_s = LINK_GAP_S if _links_routers(config) else 0.0
    ports = {endpoint.rpartition(":")[2] for endpoint in endpoints_of(config, "listen/endpoints")}
    time.sleep(gap_s)
    end = time.monotonic() + TAKEOVER_S
    while True:
        if (router := open_where_free(config)) is not None:
            return router
        if str(port()) not in ports or time.monotonic() > end or not _ask_to_give_way():
            return open_router(config)  # it raises, unless the port has become free meanwhile
        # One request doesn't suffice: a session that seeks its router at this moment doesn't hear it, and that may be
        # the owner, or one that takes the port when the owner has left it.
        _await_free_port()
        time.sleep(gap_s)


def _links_routers(config: Any) -> bool:
    """Return whether a router of this configuration connects to others."""
    return bool(endpoints_of(config, "connect/endpoints"))


def _await_free_port() -> None:
    """Wait until nobody listens at the port of the machine's router, for as long as an owner takes to leave it."""
    end = time.monotonic() + LEAVE_S
    while _is_listened_to(port()) and time.monotonic() < end:
        time.sleep(REPLY_S / 2)


def _is_listened_to(local_port: int) -> bool:
    """Return whether a program of this machine accepts connections at a port."""
    try:
        socket.create_connection(("127.0.0.1", local_port), ASK_TIMEOUT_S).close()
    except OSError:
        return False
    return True


def _ask_to_give_way() -> bool:
    """Ask the sessions of this machine to leave the port alone; return whether one answered.

    It asks again for a while: after a change of owner, the sessions seek the new one's router for up to a second, and
    until they are linked to it, nobody hears the request.
    """
    zenoh = open_library()
    config = default_configuration(
        {
            **session_settings(),
            "mode": "client",
            "connect/endpoints": [f"tcp/127.0.0.1:{port()}"],
            "connect/timeout_ms": round(1000 * ASK_TIMEOUT_S),
            "connect/exit_on_failure": True,
            "listen/endpoints": [],
        }
    )
    try:
        with closing(zenoh.open(config)) as session:  # `with session` makes a panic of a close that times out
            end = time.monotonic() + ASK_TIMEOUT_S
            while True:
                replies = session.get(
                    _give_way_key(),
                    target=zenoh.QueryTarget.ALL,
                    consolidation=zenoh.ConsolidationMode.NONE,
                    timeout=ASK_TIMEOUT_S,
                )
                if any(reply.ok is not None for reply in replies):
                    return True
                if time.monotonic() > end:
                    return False
                time.sleep(REPLY_S)
    except zenoh.ZError:
        return False


def _give_way_key() -> str:
    """Return the key of the request, which names this machine, because routers carry it to others."""
    machine = re.sub(r"[^A-Za-z0-9_.-]", "_", socket.gethostname()) or "_"
    return f"tfloom/give_way/{machine}/{port()}"
