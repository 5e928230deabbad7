"""A server of the action that the recorded commands called, built from its services and its feedback topic.

A goal of theta 0 is rejected, one of theta below 0 is executed until it is canceled, any other one succeeds.
"""

from __future__ import annotations

import contextlib
import time

import rclpy
from action_msgs.msg import GoalInfo
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.qos import qos_profile_services_default
from rclpy.service_introspection import ServiceIntrospectionState
from turtlesim.action import RotateAbsolute

SUCCEEDED, CANCELED = 4, 5
SLOW = 7
"""The theta of a goal that is accepted late."""
NAME = "/turtle1/rotate_absolute/_action"
Impl = RotateAbsolute.Impl
thetas: dict[bytes, float] = {}
canceled: set[bytes] = set()


def on_goal(request: Impl.SendGoalService.Request, response: Impl.SendGoalService.Response) -> object:
    if request.goal.theta == SLOW:
        time.sleep(2.0)
    response.accepted = request.goal.theta != 0
    thetas[bytes(request.goal_id.uuid)] = request.goal.theta
    return response


def on_result(request: Impl.GetResultService.Request, response: Impl.GetResultService.Response) -> object:
    goal = bytes(request.goal_id.uuid)
    message = Impl.FeedbackMessage(goal_id=request.goal_id)
    for remaining in (-0.5, -0.25):
        message.feedback.remaining = remaining
        feedback.publish(message)
    while thetas[goal] < 0 and goal not in canceled:
        time.sleep(0.01)
    response.status = CANCELED if goal in canceled else SUCCEEDED
    response.result.delta = -2.0
    return response


def on_cancel(request: Impl.CancelGoalService.Request, response: Impl.CancelGoalService.Response) -> object:
    canceled.add(bytes(request.goal_info.goal_id.uuid))
    print("canceling", flush=True)
    response.goals_canceling = [GoalInfo(goal_id=request.goal_info.goal_id)]
    return response


rclpy.init()
node = rclpy.create_node("turtlesim")
group = ReentrantCallbackGroup()
feedback = node.create_publisher(Impl.FeedbackMessage, f"{NAME}/feedback", 10)
goals = node.create_service(Impl.SendGoalService, f"{NAME}/send_goal", on_goal, callback_group=group)
goals.configure_introspection(
    node.get_clock(), qos_profile_services_default, ServiceIntrospectionState.CONTENTS
)
node.create_service(Impl.GetResultService, f"{NAME}/get_result", on_result, callback_group=group)
node.create_service(Impl.CancelGoalService, f"{NAME}/cancel_goal", on_cancel, callback_group=group)
executor = MultiThreadedExecutor(4)
executor.add_node(node)
print("ready", flush=True)
with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
    executor.spin()
