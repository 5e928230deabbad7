"""Stand in for Nav2: two managed nodes, their manager, and a robot that drives straight to its goal.

`patrol.py` needs it; `nav2_msgs` comes with Nav2, or with tfloom-interfaces.
"""

from __future__ import annotations

import math
import time
from typing import Any

import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav2_msgs.action import NavigateToPose
from nav2_msgs.srv import ManageLifecycleNodes
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

LATCHED = QoSProfile(
    depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, reliability=ReliabilityPolicy.RELIABLE
)
STEP_S = 0.1
STEP_M = 0.25
HALF_WIDTH_OF_MAP_M = 5.0


class Localization(LifecycleNode):
    """The node /amcl: while active, it takes the initial pose for the robot's."""

    def __init__(self) -> None:
        super().__init__("amcl")
        self.publisher = self.create_lifecycle_publisher(PoseWithCovarianceStamped, "amcl_pose", LATCHED)
        self.subscription = self.create_subscription(
            PoseWithCovarianceStamped, "initialpose", self.on_initial_pose, 10
        )

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return TransitionCallbackReturn.SUCCESS

    def on_initial_pose(self, message: PoseWithCovarianceStamped) -> None:
        if self.publisher.is_activated:
            self.publisher.publish(message)


class BehaviorNavigator(LifecycleNode):
    """The node /bt_navigator: the action navigate_to_pose."""

    def __init__(self) -> None:
        super().__init__("bt_navigator")
        self.active = False
        self.x = 0.0
        self.y = 0.0
        self.server = ActionServer(
            self,
            NavigateToPose,
            "navigate_to_pose",
            self.drive,
            goal_callback=self.on_goal,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.active = True
        return super().on_activate(state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.active = False
        return TransitionCallbackReturn.SUCCESS

    def on_goal(self, goal: NavigateToPose.Goal) -> GoalResponse:
        accepted = self.active and goal.pose.header.frame_id == "map"
        return GoalResponse.ACCEPT if accepted else GoalResponse.REJECT

    def drive(self, goal_handle: ServerGoalHandle[Any, Any, Any]) -> NavigateToPose.Result:
        """Drive a step at a time, with feedback after each."""
        goal = goal_handle.request.pose.pose.position
        begin = self.get_clock().now()
        while (distance := math.hypot(goal.x - self.x, goal.y - self.y)) > 0.0:
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                return NavigateToPose.Result()
            part = min(STEP_M / distance, 1.0)
            x = self.x + part * (goal.x - self.x)
            y = self.y + part * (goal.y - self.y)
            if max(abs(x), abs(y)) > HALF_WIDTH_OF_MAP_M:
                goal_handle.abort()
                return NavigateToPose.Result(error_code=1, error_msg="the goal is beyond the map")
            self.x, self.y = x, y
            feedback = NavigateToPose.Feedback(distance_remaining=distance * (1.0 - part))
            feedback.current_pose.header.frame_id = "map"
            feedback.current_pose.pose.position.x = x
            feedback.current_pose.pose.position.y = y
            feedback.navigation_time = (self.get_clock().now() - begin).to_msg()
            goal_handle.publish_feedback(feedback)
            time.sleep(STEP_S)
        goal_handle.succeed()
        return NavigateToPose.Result()


class Manager(Node):
    """The node /lifecycle_manager_navigation, which starts and shuts down the managed nodes."""

    def __init__(self, *nodes: LifecycleNode) -> None:
        super().__init__("lifecycle_manager_navigation")
        self.nodes = nodes
        self.service = self.create_service(ManageLifecycleNodes, "~/manage_nodes", self.on_request)

    def on_request(
        self, request: ManageLifecycleNodes.Request, response: ManageLifecycleNodes.Response
    ) -> ManageLifecycleNodes.Response:
        for node in self.nodes:
            if request.command == ManageLifecycleNodes.Request.STARTUP:
                node.trigger_configure()
                node.trigger_activate()
            elif request.command == ManageLifecycleNodes.Request.SHUTDOWN:
                node.trigger_shutdown()
        response.success = True
        return response


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()
    try:
        managed = Localization(), BehaviorNavigator()
        for node in (*managed, Manager(*managed)):
            executor.add_node(node)
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
