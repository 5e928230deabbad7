"""Raises in the callback of /chatter."""

import rclpy
from std_msgs.msg import String


def on_message(message):
    raise ValueError(f"cannot bear {message.data}")


rclpy.init()
node = rclpy.create_node("raising")
node.create_subscription(String, "chatter", on_message, 10)
print("ready", flush=True)
rclpy.spin(node)
