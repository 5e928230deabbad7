"""A server of an action whose feedback and result hold lists; it sends feedback before it accepts a goal, too."""

from __future__ import annotations

import time

import rclpy
from example_interfaces.action import Fibonacci
from serving import serve

NAME = "/count/_action"
Impl = Fibonacci.Impl


def publish(goal_id: object, sequence: list[int]) -> None:
    feedback.publish(Impl.FeedbackMessage(goal_id=goal_id, feedback=Fibonacci.Feedback(sequence=sequence)))


def on_goal(request: Impl.SendGoalService.Request, response: Impl.SendGoalService.Response) -> object:
    publish(request.goal_id, [0])
    time.sleep(0.2)  # the feedback overtakes the response, whichever way each takes
    response.accepted = True
    return response


def on_result(request: Impl.GetResultService.Request, response: Impl.GetResultService.Response) -> object:
    publish(request.goal_id, [0, 1])
    time.sleep(0.2)
    response.status = 4
    response.result.sequence = [0, 1, 1]
    return response


rclpy.init()
node = rclpy.create_node("counter")
feedback = node.create_publisher(Impl.FeedbackMessage, f"{NAME}/feedback", 10)
node.create_service(Impl.SendGoalService, f"{NAME}/send_goal", on_goal)
node.create_service(Impl.GetResultService, f"{NAME}/get_result", on_result)
node.create_service(Impl.CancelGoalService, f"{NAME}/cancel_goal", lambda _, response: response)
serve(node)
