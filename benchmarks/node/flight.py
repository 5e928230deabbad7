"""One message in flight at a time: numbers for the messages, and the time of each trip."""

from __future__ import annotations

import threading
import time


class FlightError(Exception):
    """A message departed or arrived out of turn, so the times are not those of single trips."""


class Flight:
    """Records trips there and back, of which at most one is under way.

    `depart` is called by the thread that measures, `arrive` by the thread that runs callbacks; `landed` passes the
    other attributes between them.
    """

    def __init__(self) -> None:
        self.landed = threading.Event()
        self.landed.set()
        self.times_us: list[float] = []
        self._next = 1
        self._start_ns = 0
        self._fault: str | None = None

    @property
    def next_number(self) -> int:
        """Return the number for the message that departs next, which no earlier message had."""
        return self._next

    def depart(self) -> None:
        """Begin a trip now.

        Raises:
            FlightError: a message is under way, or arrived out of turn.
        """
        self.check()
        if not self.landed.is_set():
            raise FlightError(f"message {self._next} departs while {self._next - 1} is in flight")
        self.landed.clear()
        self._next += 1
        self._start_ns = time.perf_counter_ns()

    def arrive(self, number: int, at_ns: int) -> None:
        """End the trip that is under way.

        Args:
            number: The number in the message that arrived.
            at_ns: The value of `perf_counter_ns` at its arrival.
        """
        if self.landed.is_set():
            self._fault = f"message {number} arrived while none was in flight"
        elif number != self._next - 1:
            self._fault = f"message {number} arrived while {self._next - 1} was in flight"
        else:
            self.times_us.append((at_ns - self._start_ns) / 1e3)
        self.landed.set()

    def check(self) -> None:
        """Raise FlightError if a message arrived out of turn."""
        if self._fault is not None:
            raise FlightError(self._fault)
