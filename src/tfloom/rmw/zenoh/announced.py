"""The tokens that the router of a session has, by which a graph knows whether some are still to come.

Nothing tells a session when all of them have come. Its router tells it nothing of its peers' tokens, which come by
links that are made one by one; and those of others may come late, where a program or the machine is busy. A client of
the router gets all of them, and the end of the reply says so.
"""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from contextlib import closing, suppress
from typing import Any

from tfloom.rmw.zenoh.library import open_library

__all__ = ["AnnouncedTokens"]

REPLY_S = 10.0
"""How long the router may take to reply with all its tokens [s]; a listing ends before."""
END_S = 2.0
"""How long the end waits for the session of the question, whose router may be stopped by then [s]."""
AGAIN_S = 0.3
"""How long after a reply, or without one, the router is asked again [s]: tokens that are missing may have ended."""


class AnnouncedTokens:
    """What a router has, asked on a thread and by a separate session.

    Args:
        open_client: Opens a `zenoh.Session` as a client of the router, or raises a ZError soon.
        pattern: The key expression of the tokens.
    """

    def __init__(self, open_client: Callable[[], Any], pattern: str) -> None:
        self._open_client = open_client
        self._pattern = pattern
        self._lock = threading.Lock()
        """Guards the thread and its start."""
        self._thread: threading.Thread | None = None
        self._ended = threading.Event()
        self._is_closed = False
        # Written by the thread, and read once it has ended.
        self._keys: set[str] | None = None
        self._ended_s = -math.inf

    def are_here(self, lacks: Callable[[str], bool]) -> bool:
        """Return whether the router has replied, and all of its tokens are here.

        Args:
            lacks: Whether a token is to come, by its key.
        """
        with self._lock:
            if self._is_closed or (self._thread is not None and self._thread.is_alive()):
                return False
            if self._keys is not None and not any(map(lacks, self._keys)):
                return True
            if time.monotonic() > self._ended_s + AGAIN_S:
                self._keys = None
                self._ended.clear()
                self._thread = threading.Thread(target=self._run, name="tfloom_zenoh_announced", daemon=True)
                with suppress(RuntimeError):  # the system has no thread
                    self._thread.start()
            return False

    def _run(self) -> None:
        zenoh = open_library()
        keys: set[str] = set()
        failures: list[Any] = []

        def add(reply: Any) -> None:
            if reply.ok is None:
                failures.append(reply)  # as that the time is over
            else:
                keys.add(str(reply.ok.key_expr))

        try:
            # `with client` would make a panic of a close that times out.
            with closing(self._open_client()) as client:
                client.liveliness().get(
                    self._pattern,
                    zenoh.handlers.Callback(add, self._ended.set, indirect=False),
                    timeout=REPLY_S,
                )
                has_ended = self._ended.wait(2 * REPLY_S)
                if has_ended and not (failures or self._is_closed):
                    self._keys = keys
        except zenoh.ZError:  # it doesn't answer
            pass
        self._ended_s = time.monotonic()

    def close(self) -> None:
        """End the thread; a router that doesn't answer is waited for, for a short time."""
        with self._lock:
            self._is_closed = True
            self._ended.set()
            thread = self._thread
        if thread is not None and thread.is_alive():
            thread.join(END_S)
