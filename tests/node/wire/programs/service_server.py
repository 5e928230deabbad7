"""Serves /add, which adds, and /hang, which never answers."""

import time

import rclpy
from example_interfaces.srv import AddTwoInts


def add(request, response):
    response.sum = request.a + request.b
    return response


def hang(request, response):
    print("hanging", flush=True)
    while True:
        time.sleep(1)


rclpy.init()
node = rclpy.create_node("server")
node.create_service(AddTwoInts, "add", add)
node.create_service(AddTwoInts, "hang", hang)
print("ready", flush=True)
rclpy.spin(node)
