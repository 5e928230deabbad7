"""The buffer: transforms between frames go in, the transform between any two at any known time comes out."""

from __future__ import annotations

from tfloom.tf2.velocity import Velocities

__all__ = ["LATEST", "Buffer"]

LATEST = 0
"""As a query's stamp: the newest time at which the whole chain is known."""

DEFAULT_CACHE_TIME_NS = 10_000_000_000


class Buffer(Velocities):
    """A tree of frames over time. All methods may be called from any thread.

    Args:
        cache_time_ns: How far back each frame's history reaches from its newest sample [ns]; None: without limit.

    What it rejects, it logs to the logger `tfloom.tf2`, or where `set_log_callback` says.
    """

    def __init__(self, cache_time_ns: int | None = DEFAULT_CACHE_TIME_NS) -> None:
        super().__init__(cache_time_ns)
        self.set_log_callback(_log)


def _log(severity: int, text: str) -> None:
    import logging

    logging.getLogger("tfloom.tf2").log(severity, text)
