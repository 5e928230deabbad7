"""Measure a thousand timers at 10 Hz: their share of a core and their jitter, beside asyncio's."""

from __future__ import annotations

import asyncio
import json
import sys
import time
from typing import Any, NamedTuple

from benchmarks.node.processes import run
from benchmarks.node.round_trip import percentile

TIMERS = 1000
PERIOD_S = 0.1
WARM_UP_S = 0.3
MEASURED_S = 2.0


class Kept(NamedTuple):
    percent: float
    """CPU time of the process [% of a core]."""
    p50_ms: float
    """Difference between a timer's period and the time between two of its calls."""
    p99_ms: float


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
        if len(self.misses) < expected * 0.8:
            raise RuntimeError(f"only {len(self.misses)} calls, not some {expected:.0f}")
        return Kept(cpu / elapsed * 100, percentile(self.misses, 50), percentile(self.misses, 99))


def tfloom() -> Kept:
    import rclpy

    rclpy.init()
    node = rclpy.create_node("timers")
    calls = Calls()
    for number in range(TIMERS):
        node.create_timer(PERIOD_S, lambda number=number: calls.called(number))
        time.sleep(PERIOD_S / TIMERS / 2)  # spread over the period, as in a program

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
        due = begin + number * PERIOD_S / TIMERS / 2
        loop.call_at(due, call, number, due)
    await asyncio.sleep(WARM_UP_S)
    calls.begin()
    await asyncio.sleep(MEASURED_S)
    return calls.end()


def measure() -> dict[str, Kept]:
    """Return the share of a core and the jitter of the timers of each."""
    return {api: Kept(*run("timers", api)) for api in ("tfloom", "asyncio")}


def main() -> None:
    kept: Any = tfloom() if sys.argv[1] == "tfloom" else asyncio.run(_asyncio())
    print(json.dumps(kept))


if __name__ == "__main__":
    main()
