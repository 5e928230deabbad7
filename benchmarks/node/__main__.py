"""Nodes: imports, what an idle one costs, messages a second through callbacks, and round trips."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from statistics import median

from benchmarks.node import round_trip

IMPORTS = 15
MESSAGES = 20_000
BURST = 500
IDLE_S = 3.0


def import_ms() -> float:
    """Return the time that `import rclpy` takes in a fresh process, beyond Python's own start [ms]."""
    code = "import time; t = time.perf_counter(); import rclpy; print((time.perf_counter() - t) * 1e3)"
    times = [
        float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
        for _ in range(IMPORTS)
    ]
    return median(times)


def idle_cpu() -> float:
    """Return the share of a core that a spinning node takes while nothing comes [%]."""
    code = f"""
import time, rclpy
rclpy.init(domain_id={round_trip.DOMAIN_ID})
node = rclpy.create_node("idle")
rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec=0.5)
begin = time.process_time()
rclpy.spin_until_future_complete(node, rclpy.Future(), timeout_sec={IDLE_S})
print((time.process_time() - begin) / {IDLE_S} * 100)
"""
    return float(
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    )


def messages_per_second(transforms: int) -> tuple[float, float]:
    """Return how many TFMessages of some size a callback gets a second, in-process, and what publishing costs [us]."""
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage

    import tfloom.node as rclpy
    from tfloom.node.executors import SingleThreadedExecutor

    context = rclpy.Context()
    context.init([], domain_id=round_trip.DOMAIN_ID)
    node = rclpy.create_node("burst", context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    heard = 0

    def on_message(_: TFMessage) -> None:
        nonlocal heard
        heard += 1

    publisher = node.create_publisher(TFMessage, "burst", BURST)
    node.create_subscription(TFMessage, "burst", on_message, BURST)
    message = TFMessage(transforms=[TransformStamped(child_frame_id=f"joint_{i}") for i in range(transforms)])
    round_trip.wait_for(publisher.get_subscription_count)
    publishing = spinning = 0.0
    rounds = MESSAGES // BURST // (1 if transforms == 1 else 10)
    for number in range(1, rounds + 1):
        publishing += timed(lambda: [publisher.publish(message) for _ in range(BURST)])
        spinning += timed(lambda end=number * BURST: spin_until(lambda: heard == end, executor))
    node.destroy_node()
    context.destroy()
    count = rounds * BURST
    return count / spinning, publishing / count * 1e6


def spin_until(condition: Callable[[], bool], executor: object) -> None:
    while not condition():
        executor.spin_once(timeout_sec=1.0)


def timed(act: Callable[[], object]) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start


def main() -> None:
    print(f"import rclpy: {import_ms():.1f} ms")
    print(f"a node that spins and hears nothing: {idle_cpu():.2f} % of a core")
    for transforms in (1, 50):
        rate, publish_us = messages_per_second(transforms)
        print(
            f"TFMessage x {transforms}: {rate:,.0f} a second into a callback; publishing one {publish_us:.1f} us"
        )
    sys.stdout.flush()
    round_trip.main()


main()
