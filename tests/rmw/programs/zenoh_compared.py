"""A program of ROS names alone, whose tokens, samples and requests `tests/oracles/compare_rmw_zenoh.py` compares.

It has the entities of the tokens in `tests/golden/zenoh_tokens.txt`, publishes and calls until stdin ends, and prints
`ready` when all are open.
"""

from __future__ import annotations

import sys
import threading
from contextlib import suppress

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionServer
from rclpy.executors import ExternalShutdownException
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("real_node", namespace="/real")
latched = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
node.create_subscription(String, "/chatter", print, 10)
publishers = [
    node.create_publisher(String, "/back", 10),
    node.create_publisher(String, "/be", QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)),
    node.create_publisher(String, "/ka", QoSProfile(depth=10, history=HistoryPolicy.KEEP_ALL)),
    node.create_publisher(String, "/latched_real", latched),
]
node.create_service(AddTwoInts, "/real_add", lambda request, response: response)
client = node.create_client(AddTwoInts, "/our_add")
ActionServer(node, Fibonacci, "/fib", lambda goal: Fibonacci.Result())
of_late = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
node.create_subscription(String, "/latched", print, of_late)


def act() -> None:
    for publisher in publishers:
        publisher.publish(String(data="compared"))
    if client.service_is_ready():
        client.call_async(AddTwoInts.Request(a=1, b=2))


node.create_timer(0.2, act)
threading.Thread(target=lambda: (sys.stdin.read(), rclpy.shutdown()), daemon=True).start()
print("ready", flush=True)
with suppress(ExternalShutdownException, KeyboardInterrupt):
    rclpy.spin(node)
