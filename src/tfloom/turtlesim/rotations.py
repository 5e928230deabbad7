"""The action rotate_absolute of one turtle: turn to a heading, one goal at a time."""

from __future__ import annotations

from typing import Any, NamedTuple

from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse, ServerGoalHandle
from tfloom.node.node import Node
from tfloom.node.task import Future
from tfloom.turtlesim.messages import RotateAbsolute
from tfloom.turtlesim.world import Rotation, Turtle, is_usable


class _Running(NamedTuple):
    rotation: Rotation
    handle: ServerGoalHandle
    ended: Future[None]


class RotationServer:
    """Accepts every goal and every cancel; a new goal aborts the one before it.

    Args:
        node: The node that serves.
        turtle: The turtle that turns.
    """

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self._node = node
        self._turtle = turtle
        self._running: _Running | None = None
        self._server = ActionServer(
            node,
            RotateAbsolute,
            f"{turtle.name}/rotate_absolute",
            self._execute,
            goal_callback=self._on_goal,
            cancel_callback=self._on_cancel,
        )

    def destroy(self) -> None:
        """Abort the goal, if there is one, and serve no more."""
        if self._running is not None:
            self._running.rotation.state = "aborted"
            self._settle()
        self._server.destroy()

    def tell(self, rotation: Rotation) -> None:
        """Tell how the turtle's turn stands after a step."""
        running = self._running
        if running is None or running.rotation is not rotation:
            return
        if rotation.state == "canceled":
            self._node.get_logger().info("Rotation goal canceled")
        else:
            running.handle.publish_feedback(RotateAbsolute.Feedback(remaining=rotation.remaining))
        if rotation.state == "succeeded":
            self._node.get_logger().info("Rotation goal completed successfully")
        self._settle()

    def abort_for_command(self) -> None:
        """Abort the goal: the turtle was commanded otherwise."""
        self._node.get_logger().warning("Velocity command received during rotation goal. Aborting goal")
        self._settle()

    def _on_goal(self, goal: Any) -> GoalResponse:
        if is_usable(goal.theta):
            return GoalResponse.ACCEPT
        self._node.get_logger().warning(f"Rejecting a rotation goal that is no number: theta=[{goal.theta}]")
        return GoalResponse.REJECT

    def _on_cancel(self, handle: ServerGoalHandle) -> CancelResponse:
        if self._running is not None and self._running.handle == handle:
            self._running.rotation.cancel_requested = True
        return CancelResponse.ACCEPT

    async def _execute(self, handle: ServerGoalHandle) -> Any:
        rotation, aborted = self._turtle.rotate_to(handle.request.theta)
        if aborted is not None:
            self._node.get_logger().warning(
                "Rotation goal received before a previous goal finished. Aborting previous goal"
            )
            self._settle()
        rotation.cancel_requested = handle.is_cancel_requested
        self._running = _Running(rotation, handle, Future())
        await self._running.ended
        return RotateAbsolute.Result(delta=rotation.delta)

    def _settle(self) -> None:
        """End the goal as its rotation has ended, if it has."""
        running = self._running
        if running is None or running.rotation.state == "active":
            return
        self._running = None
        if running.rotation.state == "succeeded":
            running.handle.succeed()
        elif running.rotation.state == "canceled":
            running.handle.canceled()
        else:
            running.handle.abort()
        running.ended.set_result(None)
