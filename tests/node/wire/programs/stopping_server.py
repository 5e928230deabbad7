"""Serves /STEP/add and /STEP/fibonacci, and stops at the step that is its argument, until it is shut down."""

import sys
import time
from contextlib import suppress

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionServer, GoalResponse
from rclpy.executors import ExternalShutdownException

STEP = sys.argv[1]


def stop_at(step):
    if step == STEP:
        print(f"at {step}", flush=True)
        while rclpy.ok():
            time.sleep(0.01)


def add(request, response):
    stop_at("taken")
    response.sum = request.a + request.b
    return response


def judge(goal):
    stop_at("deciding")
    return GoalResponse.ACCEPT


def begin(handle):
    stop_at("accepted")
    handle.execute()


def execute(handle):
    stop_at("executing")
    handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
    stop_at("feedback")
    handle.succeed()
    stop_at("succeeded")
    return Fibonacci.Result(sequence=[2])


rclpy.init()
node = rclpy.create_node("server", namespace=STEP)
service = node.create_service(AddTwoInts, "add", add)
action = ActionServer(
    node, Fibonacci, "fibonacci", execute, goal_callback=judge, handle_accepted_callback=begin
)
print("ready", flush=True)
stop_at("unread")
with suppress(KeyboardInterrupt, ExternalShutdownException):
    rclpy.spin(node)
