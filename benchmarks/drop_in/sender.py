"""Send a number of TFMessages on /tf at a rate, once a line of input arrives; print when they are acknowledged."""

from __future__ import annotations

import sys
import time

FIRST_STAMP_NS = 1_000_000_000_000


def main() -> None:
    import rclpy
    from builtin_interfaces.msg import Time
    from rclpy.duration import Duration
    from tf2_msgs.msg import TFMessage

    from benchmarks.node.messages import tf_message

    transforms, rate_hz, count = map(int, sys.argv[1:])
    rclpy.init()
    publisher = rclpy.create_node("sender").create_publisher(TFMessage, "/tf", 1000)
    message = tf_message(transforms)
    while not publisher.get_subscription_count():
        time.sleep(0.005)
    print("matched", flush=True)
    sys.stdin.readline()
    begin = time.monotonic()
    for number in range(count):
        seconds, nanoseconds = divmod(FIRST_STAMP_NS + number * 1_000_000_000 // rate_hz, 1_000_000_000)
        stamp = Time(sec=seconds, nanosec=nanoseconds)
        for transform in message.transforms:
            transform.header.stamp = stamp
        publisher.publish(message)
        time.sleep(max(0.0, begin + number / rate_hz - time.monotonic()))
    publisher.wait_for_all_acked(Duration(seconds=10.0))
    print(f"sent in {time.monotonic() - begin:.2f} s", flush=True)
    sys.stdin.readline()


if __name__ == "__main__":
    main()
