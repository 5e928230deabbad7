"""Offer an action that computes Fibonacci numbers with feedback, and stops when the client cancels."""

from __future__ import annotations

import time
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class FibonacciServer(Node):
    """A server of the action /fibonacci; its callback is slow, so it needs an executor with more than one thread."""

    def __init__(self) -> None:
        super().__init__("fibonacci_server")
        self.server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            execute_callback=self.execute,
            goal_callback=self.on_goal,
            cancel_callback=self.on_cancel,
            callback_group=ReentrantCallbackGroup(),
        )

    def on_goal(self, goal: Fibonacci.Goal) -> GoalResponse:
        """Accept a goal whose order is valid."""
        if 0 <= goal.order <= 40:
            return GoalResponse.ACCEPT
        self.get_logger().warning(f"Rejected the order {goal.order}")
        return GoalResponse.REJECT

    def on_cancel(self, goal_handle: ServerGoalHandle) -> CancelResponse:
        """Accept each request to cancel."""
        return CancelResponse.ACCEPT

    def execute(self, goal_handle: Any) -> Fibonacci.Result:
        """Compute a number every 0.1 s."""
        sequence = [0, 1]
        for _ in range(goal_handle.request.order):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                self.get_logger().info("Canceled")
                return Fibonacci.Result(sequence=sequence)
            sequence.append(sequence[-1] + sequence[-2])
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.1)
        goal_handle.succeed()
        self.get_logger().info(f"Computed {len(sequence)} numbers")
        return Fibonacci.Result(sequence=sequence)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()
    try:
        executor.add_node(FibonacciServer())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
