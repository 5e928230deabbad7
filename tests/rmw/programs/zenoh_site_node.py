"""A node at one end of two networks, on Zenoh; arguments: its name and the other one's.

It keeps a text on `NAME/kept`, sends one on `NAME/sent` each 20 ms, and answers on `NAME/served`. A line on stdin, with
a word, starts a check, which prints that word and what came from the other one: `sent` by a subscription from before,
`kept` by one that is new, and `served` by a client from before. A part that doesn't come is waited for.
"""

from __future__ import annotations

import sys
import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import Trigger

name, other = sys.argv[1:]
KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
has_come = threading.Event()


def answer(_request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
    response.message = name
    return response


rclpy.init()
node = rclpy.create_node(name)
kept = node.create_publisher(String, f"{name}/kept", KEPT)
kept.publish(String(data=name))
sent = node.create_publisher(String, f"{name}/sent", 1)
node.create_timer(0.02, lambda: sent.publish(String(data=name)))
node.create_service(Trigger, f"{name}/served", answer)
client = node.create_client(Trigger, f"{other}/served")
node.create_subscription(String, f"{other}/sent", lambda _: has_come.set(), 1)
executor = SingleThreadedExecutor()
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
print("ready", flush=True)

for line in sys.stdin:
    has_come.clear()
    has_come.wait()
    has_kept = threading.Event()
    subscription = node.create_subscription(
        String, f"{other}/kept", lambda _, done=has_kept: done.set(), KEPT
    )
    has_kept.wait()
    node.destroy_subscription(subscription)
    client.wait_for_service()
    response = client.call(Trigger.Request())
    print(line.strip(), "sent kept", response and response.message, flush=True)
