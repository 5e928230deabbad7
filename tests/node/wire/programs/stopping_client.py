"""Uses /STEP/add or /STEP/fibonacci for each STEP of its arguments, and stops each at it, until it is shut down."""

import sys
import time
from contextlib import suppress

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException


def finish(node, future):
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def call(node):
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=30)
    future = client.call_async(AddTwoInts.Request(a=1, b=2))
    yield "called"
    finish(node, future)
    yield "answered"


def send_goal(node):
    heard = []
    client = ActionClient(node, Fibonacci, "fibonacci")
    assert client.wait_for_server(timeout_sec=30)
    future = client.send_goal_async(Fibonacci.Goal(order=3), feedback_callback=heard.append)
    yield "goal sent"
    handle = finish(node, future)
    yield "goal accepted"
    result = handle.get_result_async()
    yield "result requested"
    while not heard:
        rclpy.spin_once(node)
    yield "feedback received"
    cancel = handle.cancel_goal_async()
    yield "cancel requested"
    finish(node, cancel)
    finish(node, result)
    yield "result received"


def run_to(step):
    """Return the call or the goal that has come to a step; nothing spins its node any more."""
    # A node each, because one that is spun for a later step would receive what an earlier one doesn't wait for.
    node = rclpy.create_node("client", namespace=step.replace(" ", "_"))
    exchange = (call if step in ("called", "answered") else send_goal)(node)
    while next(exchange) != step:
        pass
    print(f"at {step}", flush=True)
    return exchange


rclpy.init()
with suppress(KeyboardInterrupt, ExternalShutdownException):
    exchanges = [run_to(step) for step in sys.argv[1:]]
    while rclpy.ok():
        time.sleep(0.01)
