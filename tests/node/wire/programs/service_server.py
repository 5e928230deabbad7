"""Serves /add, which adds and prints its requests and responses, and /hang, which never responds."""

import time

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState


def add(request, response):
    response.sum = request.a + request.b
    return response


def hang(request, response):
    print("hanging", flush=True)
    while True:
        time.sleep(1)


rclpy.init()
node = rclpy.create_node("server")
adding = node.create_service(AddTwoInts, "add", add)
adding.configure_introspection(node.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.CONTENTS)
node.create_service(AddTwoInts, "hang", hang)
print("ready", flush=True)
rclpy.spin(node)
