"""The meeting point of one machine: a router inside one of its processes, where nobody has started one.

Two peers of Zenoh hear of each other by a router. So each session tries to open one at the port where all seek it; the
kernel gives the port to one process. When that one ends, the others lose their link, and one of them has the port next.
Peers have links of their own, so data that flows between them goes on meanwhile.
"""

from __future__ import annotations

import sys
import threading
import time
from contextlib import suppress
from typing import Any

from tfloom.rmw.errors import WireError
from tfloom.rmw.zenoh_config import meeting_point_configuration, port
from tfloom.rmw.zenoh_port import find_port_owner
from tfloom.rmw.zenoh_router import RouterError, open_router

__all__ = ["MeetingPoint"]

PERIOD_S = 0.2
"""How often a session looks whether it still has a router [s]."""
NO_ANSWER_S = 3.0
"""How long the router's silence is no cause for a message [s]: after a change of owner, sessions retry for a second."""


class MeetingPoint:
    """A session's part in the meeting point of the machine: it has the router, or takes over where nobody has it.

    A thread of its own does so. The lock guards the router: opened by that thread or by the constructor, closed by
    `close`.

    Raises:
        WireError: a router can't be opened at this port, for another reason than that it is taken.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._router: Any = None
        self._is_closed = threading.Event()
        self._thread: threading.Thread | None = None
        self._is_reported = False
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
        with self._lock:
            router, self._router = self._router, None
        if router is not None:
            router.close()

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
        print(
            f"tfloom: {text}: until it goes on or ends, new programs don't hear of each other",
            file=sys.stderr,
        )

    def _open_router(self) -> None:
        try:
            router = open_router(meeting_point_configuration())
        except RouterError as error:
            if not error.is_port_taken:
                raise
            return
        with self._lock:
            self._router = router

    def _watch(self, session: Any) -> None:
        silent_since = time.monotonic()
        while not self._is_closed.wait(PERIOD_S):
            try:
                is_linked = bool(session.info.routers_zid())
            except Exception:  # noqa: BLE001  # the session was closed by other means: there is nothing to watch
                return
            if is_linked:
                silent_since = time.monotonic()
                self._is_reported = False
                continue
            if not self.is_owner:
                # A failure other than a taken port, as a lack of descriptors, may pass: the next round tries again.
                with suppress(WireError):
                    self._open_router()
            if not self.is_owner and time.monotonic() - silent_since > NO_ANSWER_S:
                self.report_silence()
