"""Send messages once there is a subscription: at a rate, with stamps that increase by the period, or without pauses."""

from __future__ import annotations

import sys
import time
from typing import Any

FIRST_STAMP_NS = 1_000_000_000_000


def paced(transforms: int, rate_hz: int) -> None:
    """Send a TFMessage on /tf at `rate_hz`; its stamp gives the number of messages sent."""
    import rclpy
    from builtin_interfaces.msg import Time
    from tf2_msgs.msg import TFMessage

    from benchmarks.node.messages import tf_message

    rclpy.init()
    publisher = rclpy.create_node("sender").create_publisher(TFMessage, "/tf", 100)
    message = tf_message(transforms)
    while not publisher.get_subscription_count():
        time.sleep(0.005)
    begin = time.monotonic()
    for number in range(1_000_000):
        seconds, nanoseconds = divmod(FIRST_STAMP_NS + number * 1_000_000_000 // rate_hz, 1_000_000_000)
        stamp = Time(sec=seconds, nanosec=nanoseconds)
        for transform in message.transforms:
            transform.header.stamp = stamp
        publisher.publish(message)
        time.sleep(max(0.0, begin + number / rate_hz - time.monotonic()))


def flood(message: Any, count: int) -> None:
    """Send the bytes of one message `count` times on /bench; a slow receiver blocks the sender."""
    import rclpy
    from rclpy.qos import HistoryPolicy, QoSProfile

    rclpy.init()
    node = rclpy.create_node("sender")
    publisher = node.create_publisher(type(message), "/bench", QoSProfile(history=HistoryPolicy.KEEP_ALL))
    data = rclpy.serialization.serialize_message(message)
    while not publisher.get_subscription_count():
        time.sleep(0.005)
    for _ in range(count):
        publisher.publish(data)
    publisher.wait_for_all_acked()


def main() -> None:
    from benchmarks.node.messages import SIZES, octets, tf_message

    what, kind, number = sys.argv[1:]
    if what == "paced":
        paced(int(kind), int(number))
    elif kind in SIZES:
        flood(octets(SIZES[kind]), int(number))
    else:
        flood(tf_message(int(kind)), int(number))
    sys.stdin.read()  # until the measurement ends


if __name__ == "__main__":
    main()
