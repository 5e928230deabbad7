"""The buffer: stores transforms between frames and returns the transform between any two at any stored time."""

from __future__ import annotations

from tfloom.tf2.velocity import Velocities

__all__ = ["LATEST", "Buffer"]

LATEST = 0
"""Stamp of a query for the newest time at which the whole chain is known."""

DEFAULT_CACHE_TIME_NS = 10_000_000_000


class Buffer(Velocities):
    """A tree of frames over time. All methods may be called from any thread.

    Args:
        cache_time_ns: Length of each frame's history, before its newest sample [ns]; None: no limit.

    Rejected transforms are logged to the logger ``tfloom.tf2``, or by the function of `set_log_callback`.
    """

    def __init__(self, cache_time_ns: int | None = DEFAULT_CACHE_TIME_NS) -> None:
        super().__init__(cache_time_ns)
        self.set_log_callback(_log)


def _log(severity: int, text: str) -> None:
    import logging

    logging.getLogger("tfloom.tf2").log(severity, text)
