"""Receive transforms in a real rclpy, in one of WAYS; print CPU time, time and the number of transforms as JSON.

It measures between two lines of input, and spins the node meanwhile.
"""

from __future__ import annotations

import json
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

WAYS = ("drop_in", "raw", "decoding", "tf2_ros")
"""The drop-in listener by its own reader, and by a raw subscription; a decoding subscription; tf2_ros's listener."""
DEPTH = 10_000
"""History of each reader, because the default one, 100, would overwrite messages while a busy machine delays rclpy."""
MAX_DURATION_S = 10.0
CACHE_S = 3600.0


def receive(way: str, node: Any) -> Callable[[], int]:
    """Start to receive, and return a function that counts the transforms."""
    if way == "decoding":
        return _decoding(node)
    if way == "tf2_ros":
        return _tf2_ros(node)
    from rclpy.duration import Duration

    from tfloom.drop_in import Buffer, TransformListener

    buffer = Buffer(Duration(seconds=CACHE_S))
    listener = TransformListener(buffer, node, qos=DEPTH, raw=way == "raw")
    if bool(listener.why_raw) != (way == "raw"):
        raise RuntimeError(listener.why_raw)
    return lambda: sum(edge.sample_count for edge in buffer.edges())


def _decoding(node: Any) -> Callable[[], int]:
    from tf2_msgs.msg import TFMessage

    count = 0

    def callback(message: TFMessage) -> None:
        nonlocal count
        count += len(message.transforms)

    node.create_subscription(TFMessage, "/tf", callback, DEPTH)
    return lambda: count


def _tf2_ros(node: Any) -> Callable[[], int]:
    import tf2_ros

    count = 0

    class Listener(tf2_ros.TransformListener):  # type: ignore[misc]
        def callback(self, data: Any) -> None:
            nonlocal count
            count += len(data.transforms)
            super().callback(data)

    node.listener = Listener(tf2_ros.Buffer(), node, qos=DEPTH)
    return lambda: count


def main() -> None:
    import rclpy

    way, expected = sys.argv[1], int(sys.argv[2])
    rclpy.init()
    node = rclpy.create_node("receiver")
    count = receive(way, node)
    measured: list[float] = []
    ended = rclpy.task.Future()

    def measure() -> None:
        sys.stdin.readline()
        cpu, begin = time.process_time(), time.monotonic()
        sys.stdin.readline()
        measured.extend((time.process_time() - cpu, time.monotonic() - begin))
        end = time.monotonic() + MAX_DURATION_S
        while count() < expected and time.monotonic() < end:
            time.sleep(0.01)
        ended.set_result(None)

    threading.Thread(target=measure, daemon=True).start()
    rclpy.spin_until_future_complete(node, ended)
    print(json.dumps([*measured, count()]), flush=True)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
