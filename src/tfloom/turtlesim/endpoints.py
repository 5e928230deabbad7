"""The topics, services and action of one turtle: pose, colour sensor, commands, pen, teleports, rotations."""

from __future__ import annotations

from typing import Any

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.endpoints.service import Service
from tfloom.node.node import Node
from tfloom.node.turtlesim_types import Color, Pose, SetPen, TeleportAbsolute, TeleportRelative
from tfloom.rmw.typed_names import CANCEL_GOAL, FEEDBACK, GET_RESULT, SEND_GOAL, STATUS
from tfloom.turtlesim import parameters
from tfloom.turtlesim.rotations import ROTATE_ABSOLUTE, RotationServer
from tfloom.turtlesim.simulation import TurtleSim
from tfloom.turtlesim.world import Rotation, Turtle, is_usable

QOS_DEPTH = 7
POSE = "pose"
COLOR_SENSOR = "color_sensor"
CMD_VEL = "cmd_vel"
SET_PEN = "set_pen"
TELEPORT_RELATIVE = "teleport_relative"
TELEPORT_ABSOLUTE = "teleport_absolute"
TOPICS = (POSE, COLOR_SENSOR, CMD_VEL)
SERVICES = (SET_PEN, TELEPORT_RELATIVE, TELEPORT_ABSOLUTE)


def check_names(node: Node, turtle: str) -> None:
    """Check each name that a turtle's topics, services and action get in `node`: expanded and remapped.

    Raises:
        NameValidationException: one of them isn't valid.
    """
    for topic in (*TOPICS, ROTATE_ABSOLUTE + FEEDBACK, ROTATE_ABSOLUTE + STATUS):
        node.resolve_topic_name(f"{turtle}/{topic}")
    for service in (*SERVICES, *(ROTATE_ABSOLUTE + part for part in (SEND_GOAL, CANCEL_GOAL, GET_RESULT))):
        node.resolve_service_name(f"{turtle}/{service}")


class TurtleEndpoints:
    """The topics, services and action of one turtle.

    Args:
        node: The node that has them, with turtlesim's parameters.
        sim: The simulation that the turtle is part of.
        turtle: The turtle.
        rotations: The action server of the turtle's name.
    """

    def __init__(self, node: Node, sim: TurtleSim, turtle: Turtle, rotations: RotationServer) -> None:
        self._node = node
        self._sim = sim
        self._turtle = turtle
        name = turtle.name
        self._pose = node.create_publisher(Pose, f"{name}/{POSE}", QOS_DEPTH)
        self._color = node.create_publisher(Color, f"{name}/{COLOR_SENSOR}", QOS_DEPTH)
        self._cmd_vel = node.create_subscription(Twist, f"{name}/{CMD_VEL}", self._on_cmd_vel, QOS_DEPTH)
        self._services: list[Service] = [
            node.create_service(SetPen, f"{name}/{SET_PEN}", self._on_set_pen),
            node.create_service(TeleportRelative, f"{name}/{TELEPORT_RELATIVE}", self._on_teleport_relative),
            node.create_service(TeleportAbsolute, f"{name}/{TELEPORT_ABSOLUTE}", self._on_teleport_absolute),
        ]
        self._rotations = rotations
        rotations.serve(turtle)

    def destroy(self) -> None:
        """Destroy all of them, the action once its goals have ended."""
        for publisher in (self._pose, self._color):
            self._node.destroy_publisher(publisher)
        self._node.destroy_subscription(self._cmd_vel)
        for service in self._services:
            self._node.destroy_service(service)
        self._rotations.release()

    def publish(self) -> None:
        """Publish the turtle's pose and commanded velocity [m, rad, m/s, rad/s], and the colour under it."""
        turtle = self._turtle
        self._pose.publish(
            Pose(
                x=turtle.x,
                y=turtle.y,
                theta=turtle.theta,
                linear_velocity=turtle.linear_velocity,
                angular_velocity=turtle.angular_velocity,
            )
        )
        red, green, blue = self._sim.canvas.color_at(turtle.x, turtle.y)
        self._color.publish(Color(r=red, g=green, b=blue))

    def report_rotation(self, rotation: Rotation) -> None:
        """Report the state of a turn towards a goal to the goal's client."""
        self._rotations.report(rotation)

    def _rejects(self, what: str, *numbers: float) -> bool:
        """Return whether these numbers are unusable for a turtle; if so, warn."""
        if is_usable(*numbers):
            return False
        listed = ", ".join(map(str, numbers))
        self._node.get_logger().warning(
            f"Ignoring {what} for [{self._turtle.name}]: not numbers, or too large: {listed}",
            throttle_duration_sec=1.0,
        )
        return True

    def _on_cmd_vel(self, twist: Twist) -> None:
        ahead, left, turn = twist.linear.x, twist.linear.y, twist.angular.z
        if not self._rejects("a velocity command", ahead, left, turn):
            sideways = left if parameters.is_holonomic(self._node) else None
            if self._sim.world.command(self._turtle, ahead, sideways, turn) is not None:
                self._rotations.abort_for_command()

    def _on_set_pen(self, request: Any, response: Any) -> Any:
        self._turtle.set_pen((request.r, request.g, request.b), request.width, off=bool(request.off))
        return response

    def _on_teleport_relative(self, request: Any, response: Any) -> Any:
        if not self._rejects("a teleport", request.linear, request.angular):
            self._turtle.teleport_relative(request.linear, request.angular)
        return response

    def _on_teleport_absolute(self, request: Any, response: Any) -> Any:
        if not self._rejects("a teleport", request.x, request.y, request.theta):
            self._turtle.teleport(request.x, request.y, request.theta)
        return response
