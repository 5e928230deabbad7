"""Publish strings at a rate, and print how many: publisher.py TOPIC RATE SECONDS SIZE."""

from __future__ import annotations

import sys
import time

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.serialization import serialize_message
from std_msgs.msg import String

BATCHES_PER_S = 500.0


def main(topic: str, rate: float, seconds: float, size: int) -> None:
    rclpy.init()
    node = Node(topic.strip("/"))
    publisher = node.create_publisher(String, topic, QoSProfile(depth=10_000))
    while publisher.get_subscription_count() < 1:
        time.sleep(0.05)
    time.sleep(0.3)  # until the subscription knows the publisher, too
    message = serialize_message(String(data="x" * size))
    start, sent = time.perf_counter(), 0
    while (now := time.perf_counter() - start) < seconds:
        while sent < int(now * rate):
            publisher.publish(message)
            sent += 1
        time.sleep(1.0 / BATCHES_PER_S)
    publisher.wait_for_all_acked(Duration(seconds=10))
    print(sent, flush=True)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4]))
