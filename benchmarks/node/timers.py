"""Measure a thousand timers at 10 Hz: their share of a core and their jitter, beside asyncio's.

On a machine that lacks time for all calls, some are skipped. Such a turn is repeated; if no turn was complete, the one
with the most calls counts, and its share of them is in the result.
"""

from __future__ import annotations

import asyncio
import json
import sys
import time
from collections.abc import Sequence
from typing import Any, NamedTuple

from benchmarks.node.processes import run
from benchmarks.node.round_trip import percentile

TIMERS = 1000
PERIOD_S = 0.1
SPACING_S = PERIOD_S / TIMERS
"""Time between the starts of two timers: they are spread over the period, as in a program."""
WARM_UP_S = 0.3
MEASURED_S = 2.0
TURNS = 3
MAX_TURNS = 6
COMPLETE = 0.95
"""The least share of the calls in a turn that counts as complete."""


class Kept(NamedTuple):
    percent: float
    """CPU time of a call, times the calls that are due [% of a core]."""
    p50_ms: float
    """Difference between a timer's period and the time between two of its calls."""
    p99_ms: float
    share: float
    """The calls that were made, as a share of those that were due."""


class Calls:
    """Records the calls of each timer."""

    def __init__(self) -> None:
        self._last = [0.0] * TIMERS
        self._begin = self._cpu_begin = 0.0
        self.misses: list[float] = []

    def begin(self) -> None:
        self.misses.clear()
        self._begin, self._cpu_begin = time.perf_counter(), time.process_time()

    def called(self, number: int) -> None:
        now = time.perf_counter()
        self.misses.append(abs(now - self._last[number] - PERIOD_S) * 1e3)
        self._last[number] = now

    def end(self) -> Kept:
        cpu, elapsed = time.process_time() - self._cpu_begin, time.perf_counter() - self._begin
        expected = TIMERS * elapsed / PERIOD_S
        if not self.misses:
            raise RuntimeError(f"no timer was called, not some {expected:.0f} times")
        share = len(self.misses) / expected
        return Kept(
            cpu / elapsed / share * 100, percentile(self.misses, 50), percentile(self.misses, 99), share
        )


def ros() -> Kept:
    import rclpy

    rclpy.init()
    node = rclpy.create_node("timers")
    calls = Calls()
    begin = time.perf_counter()
    for number in range(TIMERS):
        while time.perf_counter() < begin + number * SPACING_S:  # a sleep would take longer
            pass
        node.create_timer(PERIOD_S, lambda number=number: calls.called(number))

    def spin(seconds: float) -> None:
        rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=seconds)

    spin(WARM_UP_S)
    calls.begin()
    spin(MEASURED_S)
    return calls.end()


async def _asyncio() -> Kept:
    loop = asyncio.get_running_loop()
    calls = Calls()

    def call(number: int, due: float) -> None:
        loop.call_at(due + PERIOD_S, call, number, due + PERIOD_S)
        calls.called(number)

    begin = loop.time()
    for number in range(TIMERS):
        due = begin + number * SPACING_S
        loop.call_at(due, call, number, due)
    await asyncio.sleep(WARM_UP_S)
    calls.begin()
    await asyncio.sleep(MEASURED_S)
    return calls.end()


def measure(some: Sequence[str]) -> dict[str, Kept]:
    """Return the share of a core and the jitter of the timers of each, in its complete turn with the least CPU time.

    Args:
        some: "asyncio", or of `processes.apis`.
    """
    turns: dict[str, list[Kept]] = {api: [] for api in some}
    for turn in range(MAX_TURNS):
        for api, kept in turns.items():
            if turn < TURNS or best(kept).share < COMPLETE:
                kept.append(Kept(*run("timers", api, api=api)))
    return {api: best(kept) for api, kept in turns.items()}


def best(turns: list[Kept]) -> Kept:
    """Return the complete turn with the least CPU time; if there is none, the one with the most calls."""
    complete = [kept for kept in turns if kept.share >= COMPLETE]
    return min(complete) if complete else max(turns, key=lambda kept: kept.share)


def main() -> None:
    kept: Any = asyncio.run(_asyncio()) if sys.argv[1] == "asyncio" else ros()
    print(json.dumps(kept))


if __name__ == "__main__":
    main()
