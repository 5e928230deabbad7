"""Send messages once there is a subscription: at a rate, or without pauses. Each message carries a number.

It sends with ROS's names alone, so that the sender may be tfloom's or rclpy's.
"""

from __future__ import annotations

import os
import struct
import sys
import threading
import time

FIRST_STAMP_NS = 1_000_000_000_000
SETTLING_S = 0.5
"""Time until a receiver of another vendor has matched, too."""


def stamp_ns(number: int, rate_hz: int) -> int:
    """Return the stamp of a message of `paced` [ns]; the first one has the number 0."""
    return FIRST_STAMP_NS + number * 1_000_000_000 // rate_hz


def number_at(stamp_ns: int, rate_hz: int) -> int:
    """Return the number of the message of `paced` with a stamp [ns]."""
    return -((FIRST_STAMP_NS - stamp_ns) * rate_hz // 1_000_000_000)


def x_of(number: int) -> float:
    """Return the x of the transforms in a message of `paced` [m].

    It alternates, so that a buffer that misses a message interpolates another x at its stamp.
    """
    return 1.5 if number % 2 else -0.75


def paced(transforms: int, rate_hz: int) -> None:
    """Send a TFMessage on /tf at `rate_hz`, with the stamp `stamp_ns` and the x `x_of` of its number."""
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
        seconds, nanoseconds = divmod(stamp_ns(number, rate_hz), 1_000_000_000)
        stamp = Time(sec=seconds, nanosec=nanoseconds)
        for transform in message.transforms:
            transform.header.stamp = stamp
            transform.transform.translation.x = x_of(number)
        publisher.publish(message)
        time.sleep(max(0.0, begin + number / rate_hz - time.monotonic()))


def flood(kind: str, count: int) -> None:
    """Send the messages of `numbered`, 1 to `count`, serialized, on /bench; a slow receiver blocks the sender."""
    import rclpy
    from rclpy.duration import Duration
    from rclpy.qos import HistoryPolicy, QoSProfile
    from rclpy.serialization import serialize_message

    from benchmarks.node.messages import NUMBER_AT, numbered

    rclpy.init()
    node = rclpy.create_node("sender")
    numbers = numbered(kind)
    publisher = node.create_publisher(numbers.type, "/bench", QoSProfile(history=HistoryPolicy.KEEP_ALL))
    data = bytearray(serialize_message(numbers.message(0)))
    while not publisher.get_subscription_count():
        time.sleep(0.005)
    time.sleep(SETTLING_S)
    for number in range(1, count + 1):
        struct.pack_into("<i", data, NUMBER_AT, number)
        publisher.publish(bytes(data))
    publisher.wait_for_all_acked(Duration(seconds=30))


def end_with_stdin() -> None:
    """End the process when stdin is closed: with the measurement, even if that was killed."""
    sys.stdin.read()
    os._exit(0)


def main() -> None:
    threading.Thread(target=end_with_stdin, daemon=True).start()
    what, kind, number = sys.argv[1:]
    if what == "paced":
        paced(int(kind), int(number))
    else:
        flood(kind, int(number))
    threading.Event().wait()  # until the measurement ends


if __name__ == "__main__":
    main()
