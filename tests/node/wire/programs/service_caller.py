"""Calls /add repeatedly, without waiting for responses."""

import rclpy
from example_interfaces.srv import AddTwoInts

rclpy.init()
node = rclpy.create_node("caller")
client = node.create_client(AddTwoInts, "add")
client.wait_for_service()
print("ready", flush=True)
node.create_timer(0.1, lambda: client.call_async(AddTwoInts.Request()))
rclpy.spin(node)
