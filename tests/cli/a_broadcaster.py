"""Two nodes that broadcast: /odometry odom -> base at 50 Hz, /localization map -> odom at 10 Hz, 0.08 s late.

/localization also publishes map -> gps with best effort, which transform listeners don't receive.
"""

from __future__ import annotations

import math
import time
from contextlib import suppress

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from tf2_ros import TransformBroadcaster

LATE = Duration(seconds=0.08)
PERIOD = Duration(seconds=0.1)


def transform(parent: str, child: str, stamp: Time) -> TransformStamped:
    """Return a transform that oscillates."""
    message = TransformStamped(child_frame_id=child)
    message.header.stamp = stamp.to_msg()
    message.header.frame_id = parent
    message.transform.translation.x = math.sin(time.monotonic())
    return message


def main() -> None:
    """Broadcast until stopped."""
    rclpy.init()
    odometry, localization = Node("odometry"), Node("localization")
    fast, slow = TransformBroadcaster(odometry), TransformBroadcaster(localization)
    weak = TransformBroadcaster(localization, qos_profile_sensor_data)

    now = localization.get_clock().now
    start = now()

    def localize() -> None:  # at the time that it was due, so that the period of the stamps is exact
        periods = (now() - start).nanoseconds // PERIOD.nanoseconds
        stamp = start + Duration(nanoseconds=periods * PERIOD.nanoseconds) - LATE
        slow.sendTransform(transform("map", "odom", stamp))
        weak.sendTransform(transform("map", "gps", stamp))

    odometry.create_timer(0.02, lambda: fast.sendTransform(transform("odom", "base", now())))
    localization.create_timer(PERIOD.nanoseconds / 1e9, localize)
    executor = SingleThreadedExecutor()
    executor.add_node(odometry)
    executor.add_node(localization)
    print("broadcasting", flush=True)
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()


if __name__ == "__main__":
    main()
