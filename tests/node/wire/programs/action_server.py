"""Serves an action: the outcome of a goal depends on its order.

0 to 40: computed, with feedback. 70: the server is destroyed during the goal, and recreated afterwards. 100: it waits
until it is cancelled. The arguments are its name and the time for which results are kept [s].
"""

import sys
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor


async def judge(goal):
    return GoalResponse.ACCEPT


async def judge_cancel(goal_handle):
    return CancelResponse.ACCEPT


def execute(goal_handle):
    order = goal_handle.request.order
    print(f"executing {order}", flush=True)
    result = Fibonacci.Result()
    if order == 70:
        servers.pop().destroy()
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[7]))
        goal_handle.succeed()
        print("destroyed", goal_handle.is_active, goal_handle.status, flush=True)
        servers.append(make_server())
        return result
    if order == 100:
        while not goal_handle.is_cancel_requested:
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[order]))
            time.sleep(0.02)
        goal_handle.canceled()
        return result
    sequence = [0, 1]
    for index in range(1, order):
        sequence.append(sequence[index] + sequence[index - 1])
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
    goal_handle.succeed()
    result.sequence = sequence
    return result


def make_server():
    return ActionServer(
        node,
        Fibonacci,
        sys.argv[1],
        execute,
        goal_callback=judge,
        cancel_callback=judge_cancel,
        callback_group=ReentrantCallbackGroup(),
        result_timeout=float(sys.argv[2]),
    )


rclpy.init()
node = rclpy.create_node("server")
servers = [make_server()]
executor = MultiThreadedExecutor(8)
executor.add_node(node)
print("ready", flush=True)
executor.spin()
