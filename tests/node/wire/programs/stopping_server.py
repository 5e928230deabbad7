"""Serves /STEP/add and /STEP/fibonacci for each STEP of its arguments, and stops each at it, until it is shut down."""

import sys
import time
from contextlib import suppress

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionServer, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor

STEPS = sys.argv[1:]


class Server:
    """Servers of a call and a goal that stop at a step."""

    def __init__(self, step):
        self.step = step
        options = {"callback_group": ReentrantCallbackGroup()}
        self.node = unspun if step == "unread" else node
        self.node.create_service(AddTwoInts, f"/{step}/add", self.add, **options)
        self.action = ActionServer(
            self.node,
            Fibonacci,
            f"/{step}/fibonacci",
            self.execute,
            goal_callback=self.judge,
            handle_accepted_callback=self.begin,
            **options,
        )

    def stop_at(self, step):
        if step == self.step:
            print(f"at {step}\n", end="", flush=True)  # the line as a whole, because other threads print, too
            while rclpy.ok():
                time.sleep(0.01)

    def add(self, request, response):
        self.stop_at("taken")
        response.sum = request.a + request.b
        return response

    def judge(self, goal):
        self.stop_at("deciding")
        return GoalResponse.ACCEPT

    def begin(self, handle):
        self.stop_at("accepted")
        handle.execute()

    def execute(self, handle):
        self.stop_at("executing")
        handle.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        self.stop_at("feedback")
        handle.succeed()
        self.stop_at("succeeded")
        return Fibonacci.Result(sequence=[2])


rclpy.init()
node, unspun = rclpy.create_node("server"), rclpy.create_node("unspun")
servers = [Server(step) for step in STEPS]
executor = MultiThreadedExecutor(2 * len(STEPS) + 2)  # because a call and a goal may both stop at a step
executor.add_node(node)
print("ready", flush=True)
print("at unread", flush=True)
with suppress(KeyboardInterrupt, ExternalShutdownException):
    executor.spin()
