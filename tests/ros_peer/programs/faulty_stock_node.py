"""A node of stock rclpy with faulty transforms, which asks a buffer server for a frame that nobody publishes.

Prints `asked` after each answer, and `absent` when it takes the server for absent `MAX_LOOKS` times in a row once it
was there. For a moment it may: a reader and a writer that come or go together are discovered one after the other.
"""

from __future__ import annotations

import math
import time

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.action import ActionClient
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TFMessage

MAX_LOOKS = 10

rclpy.init()
node = rclpy.create_node("stock")
moving = node.create_publisher(TFMessage, "/tf", 10)
fixed = node.create_publisher(TFMessage, "/tf_static", 10)  # volatile
client = ActionClient(node, LookupTransform, "tf2_buffer_server")


def send(publisher, parent, child, x):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id = parent
    transform.header.stamp = node.get_clock().now().to_msg()
    transform.transform.translation.x = x
    publisher.publish(TFMessage(transforms=[transform]))


asking = None
was_there = False
looks_without = 0
while True:
    send(moving, "world", "stock", math.nan)
    send(fixed, "world", "mast", 1.0)
    is_there = client.server_is_ready()
    looks_without = 0 if is_there else looks_without + 1
    if was_there and looks_without == MAX_LOOKS:
        print("absent", flush=True)
    was_there = was_there or is_there
    if is_there and (asking is None or asking.done()):
        if asking is not None:
            print("asked", flush=True)
        goal = LookupTransform.Goal(target_frame="world", source_frame="camra")
        asking = client.send_goal_async(goal)
    rclpy.spin_once(node, timeout_sec=0.005)
    time.sleep(0.01)
