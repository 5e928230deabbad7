"""Send a goal to an action, and print its feedback and its result; with `cancel_after`, cancel it before it ends.

`-p order:=10` sets how many numbers, `-p cancel_after:=3` after how many of them to cancel (0: never).
"""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future

ENDS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "was canceled",
    GoalStatus.STATUS_ABORTED: "was aborted",
}


class FibonacciClient(Node):
    """A client of the action /fibonacci."""

    def __init__(self) -> None:
        super().__init__("fibonacci_client")
        self.declare_parameter("order", 5)
        self.declare_parameter("cancel_after", 0)
        self.client = ActionClient(self, Fibonacci, "fibonacci")
        self.goal_handle: ClientGoalHandle | None = None

    def on_feedback(self, message: Any) -> None:
        """Print the feedback; cancel the goal after `cancel_after` numbers."""
        sequence = message.feedback.sequence
        self.get_logger().info(f"So far {list(sequence)}")
        if len(sequence) - 2 == self.get_parameter("cancel_after").value and self.goal_handle is not None:
            self.get_logger().info("That will do")
            self.goal_handle.cancel_goal_async()

    def pursue(self) -> int:
        """Send the goal, wait for its end, and return its final status."""
        log = self.get_logger()
        if not self.client.wait_for_server(timeout_sec=10.0):
            log.error("There is no server")
            return int(GoalStatus.STATUS_UNKNOWN)
        goal = Fibonacci.Goal(order=self.get_parameter("order").value)
        sending: Future[Any] = self.client.send_goal_async(goal, feedback_callback=self.on_feedback)
        rclpy.spin_until_future_complete(self, sending)
        goal_handle = sending.result()
        if goal_handle is None or not goal_handle.accepted:
            log.info("The goal was rejected")
            return int(GoalStatus.STATUS_UNKNOWN)
        self.goal_handle = goal_handle

        ending: Future[Any] = goal_handle.get_result_async()
        rclpy.spin_until_future_complete(self, ending)
        end = ending.result()
        if end is None:
            return int(GoalStatus.STATUS_UNKNOWN)
        log.info(f"The goal {ENDS[end.status]}: {list(end.result.sequence)}")
        return int(end.status)


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        return 0 if FibonacciClient().pursue() in ENDS or not rclpy.ok() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
