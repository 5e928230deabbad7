"""The session of the Zenoh wire: how a process joins, meets the others, and leaves."""

from __future__ import annotations

import atexit
import json
import os
import threading
import time
import weakref
from typing import Any, NoReturn

from tfloom.common.signals import signals_deferred
from tfloom.common.terminal import report
from tfloom.rmw.errors import ClosedError, ForkedError, WireError
from tfloom.rmw.zenoh.config import (
    endpoints_of,
    mode_of,
    needs_meeting_point,
    reason_of,
    router_checks,
    session_configuration,
)
from tfloom.rmw.zenoh.library import open_library
from tfloom.rmw.zenoh.links import why_no_links
from tfloom.rmw.zenoh.meeting_point import MeetingPoint

__all__ = ["FORK_ADVICE", "ZenohSession", "open_session", "refuse_fork"]

CHECK_PERIOD_S = 1.0
"""How long one look for a router takes at most [s]."""
POLL_S = 0.005
FLUSH_S = 0.05
"""How long a session that closes lets its links take what was written last [s].

Zenoh's word of the end of a link overtakes the samples in its queue, and nothing tells when that is empty.
"""
CLIENT_LIMIT_S = 1.0
"""How long a router may take to accept a client that asks for its tokens [s]."""
CLOSE_LIMIT_S = 1.0
"""How long the close of a peer's session is waited for [s]."""

FORK_ADVICE = (
    "this process was forked after that, and a fork has none of Zenoh's threads: start the child by "
    "multiprocessing's method 'spawn' or 'forkserver', or fork before the first node is created"
)

_opened_in: int | None = None
"""The process in which the first session was opened. In a child that was forked since, Zenoh would wait for ever."""


_open_sessions: weakref.WeakSet[ZenohSession] = weakref.WeakSet()


class ZenohSession:
    """An open session, and its part in the meeting point of the machine.

    Args:
        session: The `zenoh.Session`.
        config: Its `zenoh.Config`.
        meeting_point: Its part in the meeting point; None: the configuration names a router elsewhere.
    """

    def __init__(self, session: Any, config: Any, meeting_point: MeetingPoint | None) -> None:
        self._session = session
        self._config = config
        self._meeting_point = meeting_point
        self._pid = os.getpid()
        self._is_closed = False
        _open_sessions.add(self)

    @property
    def session(self) -> Any:
        """The `zenoh.Session`.

        Raises:
            ForkedError: this process was forked after it was opened.
            ClosedError: it was closed.
        """
        if os.getpid() != self._pid:
            refuse_fork("the Zenoh session")
        if self._is_closed:
            raise ClosedError("the Zenoh session was closed")
        return self._session

    @property
    def zid(self) -> str:
        """The session's id: lower-case hexadecimal digits, as in the tokens of its entities."""
        return str(self.session.zid())

    @property
    def is_meeting_point(self) -> bool:
        """Whether the machine's router is in this process, opened by this session."""
        return self._meeting_point is not None and self._meeting_point.is_owner

    @property
    def endpoints(self) -> list[str]:
        """The endpoints at which it seeks its router."""
        return endpoints_of(self._config, "connect/endpoints")

    def router_links(self) -> list[tuple[str, str]]:
        """Return the id of each router that the session is linked to, and the endpoint, as `tcp/127.0.0.1:7447`."""
        routers = {str(zid) for zid in self.session.info.routers_zid()}
        links = [(str(link.zid), str(link.dst)) for link in self.session.info.links()]
        return [(zid, endpoint) for zid, endpoint in links if zid in routers]

    def why_no_links(self) -> str:
        """Return, for each of `endpoints`, why there is no link, in one line."""
        return why_no_links(self._config)

    def open_client(self) -> Any:
        """Open a second `zenoh.Session`, a client of the router, which must be closed.

        Raises:
            ZError: the router doesn't answer within `CLIENT_LIMIT_S`.
        """
        zenoh = open_library()
        values = json.loads(str(self._config))
        values.pop("id", None)  # where the configuration states one, it is the first session's
        config = zenoh.Config.from_json5(
            json.dumps({key: part for key, part in values.items() if part is not None})
        )
        settings = {
            "mode": "client",
            "connect/endpoints": self.endpoints,
            "connect/timeout_ms": round(1000 * CLIENT_LIMIT_S),
            "connect/exit_on_failure": True,
            "listen/endpoints": [],
            "scouting/multicast/enabled": False,
        }
        for key, setting in settings.items():
            config.insert_json5(key, json.dumps(setting))
        return zenoh.open(config)

    def wait_for_router(self, timeout_s: float) -> bool:
        """Wait until the session is linked to a router, and return whether it is.

        Args:
            timeout_s: The longest wait [s].
        """
        end = time.monotonic() + timeout_s
        while not self.session.info.routers_zid():
            if time.monotonic() > end:
                return False
            time.sleep(POLL_S)
        return True

    def close(self) -> None:
        """Leave, after all that was written has been sent. A router in this process ends, and another takes over.

        Of a client Zenoh waits some seconds for a router that is stopped and takes nothing; a line tells it then. It
        must not be called in a callback of Zenoh. A second call, and one in a forked child, does nothing.
        """
        if self._is_closed or os.getpid() != self._pid:
            return
        self._is_closed = True
        try:
            if self._session.info.routers_zid():
                time.sleep(FLUSH_S)
            if mode_of(self._config) == "client":
                with (
                    signals_deferred()
                ):  # requests of this session end within it, and their clients are called
                    self._session.close()
            else:
                self._close_peer()
        except open_library().ZError as error:
            text = f"what was written last may be lost, because the Zenoh session can't be closed: {reason_of(error)}"
            report(f"tfloom: {text}")
        finally:
            if self._meeting_point is not None:
                self._meeting_point.close()

    def _close_peer(self) -> None:
        """Close the session of a peer, but don't wait long for the handshake with a program that is stopped.

        Zenoh waits for that for ten seconds before it ends its links to others, which have all that was written by
        then. A thread does so instead, and ends; the end of the process ends the links, too.
        """
        errors: list[Exception] = []

        def close() -> None:
            try:
                self._session.close()
            except open_library().ZError as error:
                errors.append(error)

        thread = threading.Thread(target=close, name="tfloom_zenoh_close", daemon=True)
        try:
            thread.start()
        except RuntimeError:  # the system has none; nor does an interpreter that ends
            self._session.close()
            return
        thread.join(CLOSE_LIMIT_S)
        if errors:
            raise errors[0]


def open_session(domain_id: int = 0) -> ZenohSession:
    """Join by the environment's configuration, and look for the router as ZENOH_ROUTER_CHECK_ATTEMPTS says.

    Args:
        domain_id: The domain, for messages: domains share the links and the router, and are told apart by their keys.

    Raises:
        ConfigurationError: a variable is invalid, or the file can't be read.
        NoBackendError: eclipse-zenoh isn't installed.
        ForkedError: this process was forked from one with a session.
        WireError: Zenoh can't open a session with this configuration.
    """
    global _opened_in  # noqa: PLW0603  # a fact about the process
    if _opened_in not in {None, os.getpid()}:
        refuse_fork("a Zenoh session")
    zenoh = open_library()
    config = session_configuration()
    checks = router_checks()
    _opened_in = os.getpid()
    meeting_point = MeetingPoint() if needs_meeting_point(config) else None
    try:
        opened = ZenohSession(zenoh.open(config), config, meeting_point)
    except zenoh.ZError as error:
        if meeting_point is not None:
            meeting_point.close()
        where = ", ".join(endpoints_of(config, "connect/endpoints")) or "nothing"
        raise WireError(
            f"Zenoh can't open a session in domain {domain_id}, of mode {mode_of(config)}, connecting to {where}: "
            f"{reason_of(error)}{_why_no_client(config)}"
        ) from None
    try:
        if meeting_point is not None:
            meeting_point.watch(opened.session)
        _look_for_router(opened, meeting_point, checks)
    except BaseException:
        opened.close()
        raise
    return opened


@atexit.register
def _close_at_exit() -> None:
    """Close what a program leaves open: a callback after the interpreter's end makes Zenoh's thread panic on stderr."""
    for opened in list(_open_sessions):
        opened.close()


def refuse_fork(what: str) -> NoReturn:
    """Raise the error of a use in a forked child.

    Args:
        what: What the parent opened, as `the writer of /chatter`.

    Raises:
        ForkedError: always.
    """
    raise ForkedError(f"{what} was opened by the parent process: {FORK_ADVICE}")


def _look_for_router(opened: ZenohSession, meeting_point: MeetingPoint | None, checks: int | None) -> None:
    """Look for a router `checks` times, a second each; without end if it is None. Print a line where there is none."""
    if not opened.endpoints:
        return
    done = 0
    while checks is None or done < checks:
        if opened.wait_for_router(CHECK_PERIOD_S):
            return
        done += 1
        if done in {1, checks}:
            if meeting_point is not None:
                meeting_point.report_silence()
            elif done == 1:
                report(
                    f"tfloom: no router answers: {opened.why_no_links()}; start one there, by `ros2 run "
                    "rmw_zenoh_cpp rmw_zenohd` or `tfloom zenoh router`. The link is made as soon as it answers"
                )


def _why_no_client(config: Any) -> str:
    """Return why a client, which is nothing without its router, has no link; empty for a peer."""
    return f"; {why_no_links(config)}" if mode_of(config) == "client" else ""
