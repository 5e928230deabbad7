"""Subscribes to as many topics as its argument, and prints when each has been received."""

import sys

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("listener")
heard = set()
for number in range(int(sys.argv[1])):
    node.create_subscription(String, f"topic_{number}", lambda message: heard.add(message.data), 10)
print("ready", flush=True)
while len(heard) < int(sys.argv[1]):
    rclpy.spin_once(node)
print("heard all", flush=True)
rclpy.spin(node)
