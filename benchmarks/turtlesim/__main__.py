"""Measure turtles that move, draw and publish: their share of a core at 62.5 steps a second, and the jitter of poses.

Each number of turtles is measured in its own process on DDS. Jitter is the difference between 16 ms and the time
between two published poses of a turtle.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time

from benchmarks.domain import DOMAIN_ID
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.turtlesim.node import TurtlesimNode
from tfloom.turtlesim.world import STEP_S

COUNTS = (1, 10, 100)
WARM_UP_S = 1.0
MEASURED_S = 5.0


class CrowdedNode(TurtlesimNode):
    """Many turtles, each on its own circle; records the times at which it publishes the first one's pose."""

    def __init__(self, count: int) -> None:
        super().__init__()
        self.published: list[float] = []
        for i in range(count - 1):
            turtle = self.sim.world.spawn(2.0 + i % 8, 2.0 + i // 8 % 8, i / 10)
            if turtle is not None:
                self._show(turtle)

    def _step(self) -> None:
        self.published.append(time.perf_counter())
        for turtle in self.sim.world.turtles.values():
            self.sim.world.command(turtle, 1.0, None, 1.0)
        super()._step()


def measure(count: int) -> None:
    """Print the share of a core and the jitter of `count` turtles."""
    init(args=["--ros-args", "--log-level", "error"])
    node = CrowdedNode(count)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    spin_for(executor, WARM_UP_S)
    node.published.clear()
    began, cpu_began = time.perf_counter(), time.process_time()
    spin_for(executor, MEASURED_S)
    share = (time.process_time() - cpu_began) / (time.perf_counter() - began)
    gaps = [later - earlier for earlier, later in zip(node.published, node.published[1:], strict=False)]
    jitter_ms = sorted(abs(gap - STEP_S) * 1e3 for gap in gaps)
    median, late = jitter_ms[len(gaps) // 2], jitter_ms[len(gaps) * 99 // 100]
    print(
        f"{count:4} turtles: {share * 100:5.1f} % of a core, {len(gaps) / MEASURED_S:.1f} steps/s, "
        f"jitter p50 {median:.2f} ms, p99 {late:.2f} ms"
    )
    executor.shutdown()
    node.destroy_node()
    try_shutdown()


def spin_for(executor: SingleThreadedExecutor, duration_s: float) -> None:
    """Spin for `duration_s`."""
    end = time.perf_counter() + duration_s
    while (left := end - time.perf_counter()) > 0.0:
        executor.spin_once(timeout_sec=left)


def main() -> None:
    """Measure each number of turtles in its own process."""
    environment = os.environ | {
        "ROS_DOMAIN_ID": str(DOMAIN_ID),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    }
    for count in COUNTS:
        command = [sys.executable, "-m", "benchmarks.turtlesim", str(count)]
        subprocess.run(command, env=environment, check=True)


if len(sys.argv) > 1:
    measure(int(sys.argv[1]))
else:
    main()
