"""Uses /STEP/add or /STEP/fibonacci, and stops at the step that is its argument, until it is shut down."""

import sys
import time
from contextlib import suppress

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException

STEP = sys.argv[1]


def stop_at(step):
    if step == STEP:
        print(f"at {step}", flush=True)
        while rclpy.ok():
            time.sleep(0.01)


def finish(future):
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def call():
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(timeout_sec=30)
    future = client.call_async(AddTwoInts.Request(a=1, b=2))
    stop_at("called")
    finish(future)
    stop_at("answered")


def send_goal():
    heard = []
    client = ActionClient(node, Fibonacci, "fibonacci")
    assert client.wait_for_server(timeout_sec=30)
    future = client.send_goal_async(Fibonacci.Goal(order=3), feedback_callback=heard.append)
    stop_at("goal sent")
    handle = finish(future)
    stop_at("goal accepted")
    result = handle.get_result_async()
    stop_at("result requested")
    while not heard:
        rclpy.spin_once(node)
    stop_at("feedback received")
    cancel = handle.cancel_goal_async()
    stop_at("cancel requested")
    finish(cancel)
    finish(result)
    stop_at("result received")


rclpy.init()
node = rclpy.create_node("client", namespace=STEP.replace(" ", "_"))
print("ready", flush=True)
with suppress(KeyboardInterrupt, ExternalShutdownException):
    call() if STEP in ("called", "answered") else send_goal()
