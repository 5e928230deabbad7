"""Warnings about clients' requests that can't be done."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from foxglove import StatusLevel

from tfloom.common.terminal import shown

if TYPE_CHECKING:
    from foxglove.websocket import WebSocketServer

    from tfloom.node.log.rcutils_logger import RcutilsLogger

__all__ = ["Complaints"]

PERIOD_S = 1.0
MAX_IN_PERIOD = 20
"""Number of warnings in a period; further ones are only counted, and the next period begins with their number, and has
one warning more."""
MAX_TEXT = 500
"""Number of characters of a warning, in which a client's own words may be of any length."""


class Complaints:
    """Logs warnings, and sends them to all clients, on any thread.

    Only a few are sent in each period, because the server closes the connections of clients for which too many
    warnings wait: one client's invalid messages would end the connections of others.

    Args:
        logger: The node's.
        clock: Returns a time that only advances [s].
    """

    def __init__(self, logger: RcutilsLogger, clock: Callable[[], float] = time.monotonic) -> None:
        self._logger = logger
        self._clock = clock
        self._lock = threading.Lock()
        """Guards the members below."""
        self._begin_s = clock()
        self._said = 0
        self._most = MAX_IN_PERIOD
        """Number of warnings in the present period."""
        self._left_out = 0

    def say(self, text: str, server: WebSocketServer | None) -> None:
        """Log a warning, and send it to the server's clients; above `MAX_IN_PERIOD`, only count it."""
        with self._lock:
            texts = self._texts(text)
        for sentence in (shown(one[:MAX_TEXT].replace("\n", " ")) for one in texts):
            self._logger.warning(sentence)
            if server is not None:
                server.publish_status(sentence, StatusLevel.Warning)

    def _texts(self, text: str) -> list[str]:
        now_s = self._clock()
        texts: list[str] = []
        if now_s - self._begin_s >= PERIOD_S:
            # As long as there are too many, so that one that reads slowly isn't closed after a few periods.
            self._most = 1 if self._left_out else MAX_IN_PERIOD
            if self._left_out:
                texts.append(f"{self._left_out} more requests of clients could not be done")
            self._begin_s, self._said, self._left_out = now_s, 0, 0
        if self._said < self._most:
            self._said += 1
            return [*texts, text]
        self._left_out += 1
        return texts
