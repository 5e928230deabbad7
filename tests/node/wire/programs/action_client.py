"""Sends a goal that waits until it is cancelled, and waits for its result."""

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient

rclpy.init()
node = rclpy.create_node("client")
client = ActionClient(node, Fibonacci, "fibonacci")
assert client.wait_for_server(timeout_sec=30)
future = client.send_goal_async(Fibonacci.Goal(order=100))
rclpy.spin_until_future_complete(node, future)
print("accepted" if future.result().accepted else "refused", "ready", flush=True)
rclpy.spin_until_future_complete(node, future.result().get_result_async())
