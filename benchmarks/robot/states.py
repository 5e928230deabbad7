"""Send joint states at a rate for some seconds, and print how many transforms came back on /tf, as JSON."""

from __future__ import annotations

import json
import math
import sys
import time

import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage

from benchmarks.robot.arms import JOINTS, joint_names


def main(rate_hz: int, seconds: float) -> None:
    rclpy.init()
    node = Node("sender")
    received: list[bytes] = []
    node.create_subscription(TFMessage, "/tf", received.append, QoSProfile(depth=1000), raw=True)
    publisher = node.create_publisher(JointState, "joint_states", 10)
    while not publisher.get_subscription_count():
        time.sleep(0.005)
    print("matched", flush=True)
    state = JointState(name=joint_names())
    begin = time.monotonic()
    sent = int(rate_hz * seconds)
    for number in range(sent):
        state.header.stamp = node.get_clock().now().to_msg()
        state.position = [math.sin(0.01 * number + i) for i in range(JOINTS)]
        publisher.publish(state)
        time.sleep(max(0.0, begin + number / rate_hz - time.monotonic()))
        rclpy.spin_once(node, timeout_sec=0)
    for _ in range(50):
        rclpy.spin_once(node, timeout_sec=0.01)
    print(json.dumps({"sent": sent, "received": len(received)}))


main(int(sys.argv[1]), float(sys.argv[2]))
