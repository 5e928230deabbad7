"""Measure the time of an executor between callbacks: messages on the wire within one process, through each executor."""

from __future__ import annotations

import json
import time

from benchmarks.node.processes import run

MESSAGES = 10_000
ROUNDS = 5


def measure(api: str = "tfloom") -> dict[str, float]:
    """Return the CPU time of a callback [us] for each executor, the best of interleaved rounds.

    Args:
        api: "tfloom", or `processes.BEFORE`.
    """
    costs: dict[str, float] = run("executors", api=api)
    return costs


def main() -> None:
    import os

    os.environ["RMW_IMPLEMENTATION"] = "tfloom_local"
    import rclpy
    from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
    from rclpy.experimental import EventsExecutor
    from std_msgs.msg import Int32

    def cost_us(kind: type[Executor]) -> float:
        with rclpy.init():
            node = rclpy.create_node("counting")
            left = MESSAGES

            def count(_: Int32) -> None:
                nonlocal left
                left -= 1
                if left == 0:
                    executor.shutdown()

            node.create_subscription(Int32, "numbers", count, MESSAGES)
            publisher = node.create_publisher(Int32, "numbers", MESSAGES)
            executor = kind()
            executor.add_node(node)
            for number in range(MESSAGES):
                publisher.publish(Int32(data=number))
            before = time.process_time()
            executor.spin()
            return (time.process_time() - before) / MESSAGES * 1e6

    kinds = [SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor]
    rounds = [[cost_us(kind) for kind in kinds] for _ in range(ROUNDS)]
    best = {kind.__name__: min(costs) for kind, costs in zip(kinds, zip(*rounds, strict=True), strict=True)}
    print(json.dumps(best))


if __name__ == "__main__":
    main()
