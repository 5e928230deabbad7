"""A node on the graph that never spins, so it sends no responses. It ends with its input."""

from __future__ import annotations

import sys

import rclpy
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from lifecycle_msgs.srv import GetState
from std_srvs.srv import Empty

rclpy.init()
node = rclpy.create_node("a_silent_node")
node.create_service(Empty, "/silence", lambda _, response: response)
node.create_service(GetState, "~/get_state", lambda _, response: response)
for name, kind in {"list_nodes": ListNodes, "load_node": LoadNode, "unload_node": UnloadNode}.items():
    node.create_service(kind, f"~/_container/{name}", lambda _, response: response)
print("ready", flush=True)
sys.stdin.read()
