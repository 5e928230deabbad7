"""The time of a bag that is played: it follows the monotonic clock at a rate, and can be paused and set."""

from __future__ import annotations

import time

from tfloom.bag.values import LATEST

__all__ = ["PlayClock"]


class PlayClock:
    """The time of a bag. Its methods take no lock: whoever shares it between threads must hold one."""

    def __init__(self, now_ns: int, rate: float) -> None:
        self._bag_ns = now_ns
        self._at_ns = time.monotonic_ns()
        self._rate = rate
        self._is_paused = True

    @property
    def rate(self) -> float:
        """Bag seconds per wall-clock second."""
        return self._rate

    @property
    def is_paused(self) -> bool:
        """Whether the time stands still."""
        return self._is_paused

    def now_ns(self) -> int:
        """Return the time of the bag [ns since epoch]."""
        if self._is_paused:
            return self._bag_ns
        passed_ns = (time.monotonic_ns() - self._at_ns) * self._rate
        return self._bag_ns + int(min(passed_ns, LATEST))  # a high rate makes it infinite

    def wait_s(self, stamp_ns: int) -> float:
        """Return how long it takes until a time, if it isn't paused [s]; negative if it has passed."""
        return (stamp_ns - self.now_ns()) / 1e9 / self._rate

    def set_now(self, stamp_ns: int) -> None:
        """Set the time [ns since epoch]."""
        self._bag_ns = stamp_ns
        self._at_ns = time.monotonic_ns()

    def set_rate(self, rate: float) -> None:
        """Set the rate, above 0, from now on."""
        self.set_now(self.now_ns())
        self._rate = rate

    def set_paused(self, is_paused: bool) -> None:
        """Stop the time, or let it go on."""
        self.set_now(self.now_ns())
        self._is_paused = is_paused
