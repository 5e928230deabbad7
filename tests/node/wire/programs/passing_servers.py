"""Serves /add and /fibonacci for random fractions of a second, again and again, with a gap after each.

Time in which the machine is too busy to run this program counts little: otherwise clients might never see a server.
"""

import random
import sys
import time

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionServer


def add(request, response):
    response.sum = request.a + request.b
    return response


def execute(goal):
    goal.succeed()
    return Fibonacci.Result(sequence=[goal.request.order])


def spin_for(longest_s):
    left_s = source.random() * longest_s
    while left_s > 0:
        begun_s = time.monotonic()
        rclpy.spin_once(node, timeout_sec=0.01)
        left_s -= min(time.monotonic() - begun_s, 0.015)


source = random.Random(int(sys.argv[1]))
rclpy.init()
node = rclpy.create_node("passing_servers")
print("ready", flush=True)
while True:
    service = node.create_service(AddTwoInts, "add", add)
    server = ActionServer(node, Fibonacci, "fibonacci", execute)
    spin_for(0.6)
    node.destroy_service(service)
    server.destroy()
    spin_for(0.05)
