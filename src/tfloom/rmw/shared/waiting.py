"""Waits for a token and for a server, for nodes and commands alike."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

from tfloom._native import ReadyQueue
from tfloom.rmw.base import Requester

SYNCHRONISING_S = 0.001
"""Period at which a waiting client checks a server that is about to be ready [s]."""
LOOK_AGAIN_S = 0.1
"""Period at which a waiting client checks its server [s], because a few causes of readiness post no token here."""


def wait_for_token(queue: ReadyQueue, end_s: float) -> None:
    """Wait for a token until `end_s` on the monotonic clock [s]; inf: no limit."""
    if end_s == math.inf:
        queue.wait(-1)
    elif (left_s := end_s - time.monotonic()) > 0:
        queue.wait(int(left_s * 1e9) + 1)


def wait_until_ready(
    requester: Requester,
    is_ready: Callable[[], bool],
    end_s: float = math.inf,
    *,
    queue: ReadyQueue | None = None,
    is_open: Callable[[], bool] = lambda: True,
    look_again_s: float = LOOK_AGAIN_S,
) -> bool:
    """Wait until a client's server is matched in both directions.

    Args:
        requester: The client; each match of it ends a sleep.
        is_ready: Evaluated at the start, after each match, and every `look_again_s`. An exception ends the wait.
        end_s: End of the wait, on the monotonic clock [s].
        queue: Queue to wait on, if other tokens must end a sleep, too.
        is_open: Evaluated as `is_ready` is; False ends the wait.
        look_again_s: The longest time between two evaluations [s].

    Returns:
        Whether there is a server; False at `end_s`, or when `is_open` returned False.
    """
    queue = ReadyQueue() if queue is None else queue
    requester.notify_ready(queue, 1)
    try:
        while is_open():
            if is_ready():
                return True
            now_s = time.monotonic()
            if now_s >= end_s:
                return False
            # Nothing posts a token when a handshake with a server ends, so look again soon while one is under way.
            pause_s = SYNCHRONISING_S if requester.is_synchronising() else look_again_s
            wait_for_token(queue, min(end_s, now_s + pause_s))
    finally:
        requester.notify_ready(None)
    return False
