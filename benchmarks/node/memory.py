"""The resident memory of a process over the time of a soak test, and whether it grows."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from statistics import median

MAX_GROWTH = 0.02
"""The most by which memory may grow in the steady state, as a fraction of what it was."""
WARM_UP = 0.3
"""The fraction of the time after which memory should be constant."""
WARM_UP_S = 180.0
"""The least time after which memory is constant [s]: libddsc remembers participants that have left for minutes."""
MIN_STEADY_S = 300.0


class Memory:
    """The resident memory of a process over the time of the test.

    Args:
        pid: The process.
        seconds: How long the test takes.
        warm_up: The fraction of the time after which memory should be constant; None: chosen by the time.
    """

    def __init__(self, pid: int, seconds: float, warm_up: float | None = None) -> None:
        self._status = Path(f"/proc/{pid}/status")
        if warm_up is None:
            warm_up = max(WARM_UP, WARM_UP_S / seconds) if seconds >= MIN_STEADY_S else WARM_UP
        self._warm_up = warm_up
        self._sizes: list[tuple[float, float]] = []

    def note(self, progress: float) -> None:
        """Measure it; `progress` is the fraction of the time that is over."""
        with suppress(OSError):  # not on Linux, where memory is not measured
            for line in self._status.read_text("utf-8").splitlines():
                if line.startswith("VmRSS:"):
                    self._sizes.append((progress, int(line.split()[1]) / 1024))

    def _median(self, start: float, end: float) -> float | None:
        sizes = [size for when, size in self._sizes if start <= when <= end]
        return median(sizes) if sizes else None

    def steady(self) -> tuple[float, float] | None:
        """Return the memory at the start and at the end of the steady state [MB]; None if it was not measured."""
        tenth = 0.1 * (1.0 - self._warm_up)
        start, end = self._median(self._warm_up, self._warm_up + tenth), self._median(1.0 - tenth, 1.0)
        return None if start is None or end is None else (start, end)

    def report(self) -> str:
        """Return what to print at the end."""
        steady = self.steady()
        if steady is None:
            return "not measured"
        start, end = steady
        return (
            f"RSS {start:.2f} MB at the start of the steady state, {end:.2f} MB at its end, "
            f"{100 * (end / start - 1):+.2f} %; at each tenth of the time: {', '.join(self._curve())} MB"
        )

    def _curve(self) -> list[str]:
        sizes = [self._median(tenth / 10, (tenth + 1) / 10) for tenth in range(10)]
        return [f"{size:.1f}" for size in sizes if size is not None]

    def is_flat(self) -> bool:
        """Return whether it grew by no more than MAX_GROWTH; True if it was not measured."""
        steady = self.steady()
        return steady is None or steady[1] <= steady[0] * (1 + MAX_GROWTH)
