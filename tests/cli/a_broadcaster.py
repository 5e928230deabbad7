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
from tf2_ros import TransformBroadcaster

LATE = Duration(seconds=0.08)


def transform(node: Node, parent: str, child: str, late: Duration) -> TransformStamped:
    """Return a transform that oscillates, stamped in the past."""
    message = TransformStamped(child_frame_id=child)
    message.header.stamp = (node.get_clock().now() - late).to_msg()
    message.header.frame_id = parent
    message.transform.translation.x = math.sin(time.monotonic())
    return message


def main() -> None:
    """Broadcast until stopped."""
    rclpy.init()
    odometry, localization = Node("odometry"), Node("localization")
    fast, slow = TransformBroadcaster(odometry), TransformBroadcaster(localization)
    weak = TransformBroadcaster(localization, qos_profile_sensor_data)

    def localize() -> None:
        slow.sendTransform(transform(localization, "map", "odom", LATE))
        weak.sendTransform(transform(localization, "map", "gps", LATE))

    odometry.create_timer(0.02, lambda: fast.sendTransform(transform(odometry, "odom", "base", Duration())))
    localization.create_timer(0.1, localize)
    executor = SingleThreadedExecutor()
    executor.add_node(odometry)
    executor.add_node(localization)
    print("broadcasting", flush=True)
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        executor.spin()


if __name__ == "__main__":
    main()
