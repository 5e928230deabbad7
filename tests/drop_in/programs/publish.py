"""Publish transforms with ROS's names alone, by the real rclpy or by tfloom's; arguments: the two topics.

world to turtle, x = 1.5, twenty times a second with the stamp of now; turtle to camera, x = 10, static.
"""

from __future__ import annotations

import sys
import time

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.qos import DurabilityPolicy, QoSProfile
from tf2_msgs.msg import TFMessage


def main() -> None:
    tf_topic, static_topic = sys.argv[1:]
    rclpy.init(args=[])
    node = rclpy.create_node("publisher")
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    tf = node.create_publisher(TFMessage, tf_topic, 100)
    static = node.create_publisher(TFMessage, static_topic, latched)

    def stamped(parent: str, child: str, x: float) -> TFMessage:
        transform = TransformStamped(child_frame_id=child)
        transform.header.frame_id = parent
        transform.header.stamp = node.get_clock().now().to_msg()
        transform.transform.translation.x = x
        return TFMessage(transforms=[transform])

    static.publish(stamped("turtle", "camera", 10.0))
    print("ready", flush=True)
    while True:
        tf.publish(stamped("world", "turtle", 1.5))
        time.sleep(0.05)


if __name__ == "__main__":
    main()
