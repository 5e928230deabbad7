"""Navigate as with Nav2's simple commander: start the nodes, set the pose, send goals, cancel one.

Each method spins until its answer is there, so that a program reads from top to bottom. It needs Nav2 or
`fake_navigation.py`.
"""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs.action import NavigateToPose
from nav2_msgs.srv import ManageLifecycleNodes
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.client import Client
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.task import Future

AMCL_POSE_QOS = QoSProfile(
    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
    reliability=QoSReliabilityPolicy.RELIABLE,
    history=QoSHistoryPolicy.KEEP_LAST,
    depth=1,
)
MANAGED_NODES = ("amcl", "bt_navigator")
TOO_FAR = (4.5, 1.0)
OFF_THE_MAP = (1.0, 100.0)
STATUS_TEXTS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "was canceled",
    GoalStatus.STATUS_ABORTED: "failed",
}


class Navigator(Node):
    """The robot's navigation, for a program without callbacks."""

    def __init__(self, node_name: str = "navigator", namespace: str = "") -> None:
        super().__init__(node_name=node_name, namespace=namespace)
        self.initial_pose = PoseStamped()
        self.localized = False
        self.goal_handle: ClientGoalHandle[Any, Any, Any] | None = None
        self.result_future: Future[Any] | None = None
        self.feedback: NavigateToPose.Feedback | None = None
        self.status = GoalStatus.STATUS_UNKNOWN

        self.navigation = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self.manager = self.create_client(ManageLifecycleNodes, "lifecycle_manager_navigation/manage_nodes")
        self.poses = self.create_subscription(
            PoseWithCovarianceStamped, "amcl_pose", self.on_amcl_pose, AMCL_POSE_QOS
        )
        self.initial_poses = self.create_publisher(PoseWithCovarianceStamped, "initialpose", 10)

    def pose(self, x: float, y: float) -> PoseStamped:
        """Return a pose on the map, now."""
        pose = PoseStamped()
        pose.header.frame_id = "map"
        pose.header.stamp = self.get_clock().now().to_msg()
        pose.pose.position.x = x
        pose.pose.position.y = y
        pose.pose.orientation.w = 1.0
        return pose

    def manage(self, command: int) -> bool:
        """Have all managed nodes started up or shut down."""
        return bool(self.call(self.manager, ManageLifecycleNodes.Request(command=command)).success)

    def wait_until_active(self, initial_pose: PoseStamped) -> None:
        """Wait until all managed nodes are active and the robot is localized."""
        for name in MANAGED_NODES:
            client = self.create_client(GetState, f"{name}/get_state")
            while self.call(client, GetState.Request()).current_state.label != "active":
                self.get_clock().sleep_for(Duration(seconds=0.1))
            self.get_logger().info(f"{name} is active")
            self.destroy_client(client)
        message = PoseWithCovarianceStamped(header=initial_pose.header)
        message.pose.pose = initial_pose.pose
        while not self.localized:
            self.initial_poses.publish(message)
            rclpy.spin_once(self, timeout_sec=0.5)

    def go_to_pose(self, pose: PoseStamped) -> bool:
        """Send a goal; return whether it was accepted."""
        while not self.navigation.wait_for_server(timeout_sec=1.0):
            self.get_logger().info("Waiting for navigate_to_pose")
        self.feedback = None
        sending: Future[Any] = self.navigation.send_goal_async(
            NavigateToPose.Goal(pose=pose), self.on_feedback
        )
        rclpy.spin_until_future_complete(self, sending)
        self.goal_handle = sending.result()
        if self.goal_handle is None or not self.goal_handle.accepted:
            self.get_logger().error("The goal was rejected")
            return False
        self.result_future = self.goal_handle.get_result_async()
        return True

    def is_task_complete(self) -> bool:
        """Spin for a tenth of a second; return whether the goal has ended."""
        if self.result_future is None:
            return True
        rclpy.spin_until_future_complete(self, self.result_future, timeout_sec=0.1)
        answer = self.result_future.result()
        if answer is None:
            return False
        self.status = answer.status
        reason = f": {answer.result.error_msg}" if answer.result.error_msg else ""
        self.get_logger().info(f"The goal {STATUS_TEXTS[self.status]}{reason}")
        self.result_future = None
        return True

    def cancel_task(self) -> None:
        """Cancel the goal, and wait for the server's answer."""
        if self.goal_handle is not None and self.result_future is not None:
            rclpy.spin_until_future_complete(self, self.goal_handle.cancel_goal_async())

    def call(self, client: Client[Any, Any], request: Any) -> Any:
        """Call a service, however long it takes to be there."""
        while not client.wait_for_service(timeout_sec=1.0):
            if not rclpy.ok():
                raise ExternalShutdownException
            self.get_logger().info(f"Waiting for {client.service_name}")
        answering = client.call_async(request)
        rclpy.spin_until_future_complete(self, answering)
        return answering.result()

    def on_amcl_pose(self, message: PoseWithCovarianceStamped) -> None:
        self.localized = True

    def on_feedback(self, message: Any) -> None:
        self.feedback = message.feedback


def patrol(navigator: Navigator) -> None:
    """Reach two goals, give one up, and try one that can't be reached."""
    log = navigator.get_logger()
    navigator.manage(ManageLifecycleNodes.Request.STARTUP)
    navigator.wait_until_active(navigator.pose(0.0, 0.0))
    for x, y in ((1.0, 0.0), (1.0, 1.0), TOO_FAR, OFF_THE_MAP):
        if not navigator.go_to_pose(navigator.pose(x, y)):
            continue
        while not navigator.is_task_complete():
            feedback = navigator.feedback
            if feedback is None:
                continue
            log.info(f"{feedback.distance_remaining:.1f} m to go to ({x}, {y})", throttle_duration_sec=0.5)
            if (x, y) == TOO_FAR and feedback.distance_remaining < 3.0:
                navigator.cancel_task()
    navigator.manage(ManageLifecycleNodes.Request.SHUTDOWN)
    log.info(f"After the shutdown, a goal is accepted: {navigator.go_to_pose(navigator.pose(0.0, 0.0))}")


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        patrol(Navigator())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
    return 0


if __name__ == "__main__":
    sys.exit(main())
