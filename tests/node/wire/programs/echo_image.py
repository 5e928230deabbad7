"""Publishes each image received on /there on /back."""

import rclpy
from sensor_msgs.msg import Image

rclpy.init()
node = rclpy.create_node("echo")
back = node.create_publisher(Image, "back", 10)
node.create_subscription(Image, "there", back.publish, 10)
print("ready", flush=True)
rclpy.spin(node)
