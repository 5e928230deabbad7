"""The action rotate_absolute of one turtle: turning to a heading, one goal at a time."""

from __future__ import annotations

from collections import deque
from typing import Any, NamedTuple

from tfloom.node.action.server import ActionServer, CancelResponse, GoalResponse, ServerGoalHandle
from tfloom.node.clock.clock import Clock
from tfloom.node.executing.task import Future
from tfloom.node.executing.timer import Timer
from tfloom.node.node import Node
from tfloom.node.turtlesim_types import RotateAbsolute
from tfloom.node.values.time import ClockType
from tfloom.turtlesim.world import Rotation, Turtle, is_usable

ROTATE_ABSOLUTE = "rotate_absolute"
"""The action's name, below the turtle's."""
FAREWELL_S = 1.0
"""Time for which the results of a removed turtle's goals can be requested [s]."""


class _Running(NamedTuple):
    rotation: Rotation
    handle: ServerGoalHandle
    ended: Future[None]


class RotationServer:
    """Accepts all goals and all cancel requests; a new goal aborts the previous one.

    It belongs to a turtle's name, and also serves a new turtle of that name, spawned while the old one's goals end.

    Args:
        node: The node that serves.
        name: The turtle's name.
    """

    def __init__(self, node: Node, name: str) -> None:
        self._node = node
        self._turtle: Turtle | None = None
        self._running: _Running | None = None
        self._unfinished = 0
        # The turtles of the accepted goals that have not begun, in order.
        self._meant_for: deque[Turtle] = deque()
        self._farewell: Timer | None = None
        self.is_destroyed = False
        self._server = ActionServer(
            node,
            RotateAbsolute,
            f"{name}/{ROTATE_ABSOLUTE}",
            self._execute,
            goal_callback=self._on_goal,
            cancel_callback=self._on_cancel,
        )

    def serve(self, turtle: Turtle) -> None:
        """Set the turtle that is served."""
        self._turtle = turtle
        self._stop_farewell()

    def release(self) -> None:
        """Stop serving the turtle. Its goals are aborted; their results can be requested for a limited time."""
        self._turtle = None
        if self._running is not None:
            self._running.rotation.state = "aborted"
            self._settle()
        # Clients of aborted goals still ask for the results. With none unfinished, the server can go at once; otherwise
        # it stays for a limited time, in real time, because simulated time may stand still.
        if self._unfinished:
            real_time = Clock(clock_type=ClockType.STEADY_TIME)
            self._farewell = self._node.create_timer(FAREWELL_S, self._destroy, clock=real_time)
        else:
            self._destroy()

    def _stop_farewell(self) -> None:
        if self._farewell is not None:
            self._node.destroy_timer(self._farewell)
            self._farewell = None

    def _destroy(self) -> None:
        self._stop_farewell()
        self._server.destroy()
        self.is_destroyed = True

    def report(self, rotation: Rotation) -> None:
        """Report the state of the turtle's turn after a step."""
        # A turn that a newer goal has aborted is reported no more.
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
        """Abort the goal, because a velocity command for the turtle has arrived."""
        self._node.get_logger().warning("Velocity command received during rotation goal. Aborting goal")
        self._settle()

    def _on_goal(self, goal: Any) -> GoalResponse:
        if self._turtle is None:
            return GoalResponse.REJECT
        if is_usable(goal.theta):
            self._unfinished += 1
            self._meant_for.append(self._turtle)
            return GoalResponse.ACCEPT
        self._node.get_logger().warning(
            f"Rejecting a rotation goal that is not a number: theta=[{goal.theta}]"
        )
        return GoalResponse.REJECT

    def _on_cancel(self, handle: ServerGoalHandle) -> CancelResponse:
        if self._running is not None and self._running.handle == handle:
            self._running.rotation.cancel_requested = True
        return CancelResponse.ACCEPT

    async def _execute(self, handle: ServerGoalHandle) -> Any:
        try:
            return await self._turn(handle)
        finally:
            self._unfinished -= 1

    async def _turn(self, handle: ServerGoalHandle) -> Any:
        # Between acceptance and this call the turtle may have been killed, and another one spawned under its name: the
        # goal was not meant for that one.
        turtle = self._meant_for.popleft()
        if turtle is not self._turtle:
            handle.abort()
            return RotateAbsolute.Result()
        rotation, aborted = turtle.rotate_to(handle.request.theta)
        if aborted is not None:
            self._node.get_logger().warning(
                "Rotation goal received before a previous goal finished. Aborting previous goal"
            )
            self._settle()
        # A request to cancel may have come before this goal was the running one, when `_on_cancel` could not note it.
        rotation.cancel_requested = handle.is_cancel_requested
        self._running = _Running(rotation, handle, Future())
        await self._running.ended
        return RotateAbsolute.Result(delta=rotation.delta)

    def _settle(self) -> None:
        """End the goal if its rotation has ended, with the same outcome."""
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
