"""The thread that pushes the samples of one Zenoh reader into its sink."""

from __future__ import annotations

import threading
from collections.abc import Callable
from operator import methodcaller

from tfloom._native import ReadyQueue, Sink
from tfloom.rmw.base import Sample

__all__ = ["Feeder"]

END_S = 1.0
"""How long the end waits for a push that runs a user's code [s]."""
_ENDLESS_NS = 2**62
_WAKE = 1


class Feeder:
    """Pushes what a reader has received, in order, from its start to its end.

    Zenoh delivers all topics of a session on one thread. A push may run a user's code, for example the done callback of
    a wait for a transform, which would delay all of them.

    Args:
        sink: Gets the samples.
        take: Removes and returns what waits: samples, and the gids of publishers that have left.

    Raises:
        RuntimeError: the system has no thread.
    """

    def __init__(self, sink: Sink, take: Callable[[], tuple[list[Sample], list[bytes]]]) -> None:
        self._sink: Sink | None = sink
        self._take = take
        self._queue = ReadyQueue()
        self._is_ended = False
        self._thread = threading.Thread(target=self._run, name="tfloom_zenoh_feeder", daemon=True)
        self._thread.start()
        self.wake()

    def wake(self) -> None:
        """Look for something to push; from any thread."""
        self._queue.post(_WAKE)

    def _run(self) -> None:
        while True:
            self._queue.wait(_ENDLESS_NS)
            if self._is_ended:  # what waits is the next sink's
                return
            samples, left = self._take()
            for sample in samples:
                self._call(methodcaller("push", *sample.for_sink))
            for gid in left:
                self._call(methodcaller("forget", gid))

    def _call(self, function: Callable[[Sink], None]) -> None:
        """Call a function with the sink, and report what it raises, as for any other thread."""
        sink = self._sink
        if sink is None:
            return
        try:
            function(sink)
        except Exception as error:  # a user's, which must not end the next pushes
            details = (type(error), error, error.__traceback__, self._thread)
            threading.excepthook(threading.ExceptHookArgs(details))

    def end(self) -> None:
        """Push nothing more, and release the sink. What is being pushed is waited for, for a short time."""
        self._is_ended = True
        self.wake()
        if self._thread is not threading.current_thread():
            self._thread.join(END_S)
        self._sink = None
