"""turtle_tf2_listener: spawn turtle2, which follows another frame."""

from __future__ import annotations

import math
from typing import Any

from tfloom.interfaces.geometry_msgs.msg import TransformStamped, Twist
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.turtlesim_types import Spawn
from tfloom.node.values.time import Time
from tfloom.node.velocities import Velocities, spin_driver
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_listener import TransformListener

FOLLOWER = "turtle2"
PERIOD_S = 1.0
TURN_GAIN = 1.0
"""Turning rate for each radian between heading and target [1/s]."""
SPEED_GAIN = 0.5
"""Speed for each metre to the target [1/s]."""


class FrameListener(Node):
    """Commands turtle2, once a second, towards the frame of the parameter `target_frame`."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_listener")
        self.target_frame = str(self.declare_parameter("target_frame", "turtle1").value)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.spawner = self.create_client(Spawn, "spawn")
        self.answer: Any = None
        self.is_spawned = False
        self.velocities = Velocities(self.create_publisher(Twist, f"{FOLLOWER}/cmd_vel", 1))
        self.timer = self.create_timer(PERIOD_S, self.on_timer)

    def on_timer(self) -> None:
        """Spawn the follower; when it has been spawned, drive it."""
        if self.is_spawned:
            self.follow()
        elif self.answer is None:
            self.spawn()
        elif self.answer.done():
            self.get_logger().info(f"Successfully spawned {self.answer.result().name}")
            self.is_spawned = True
        else:
            self.get_logger().info("Spawn is not finished")

    def spawn(self) -> None:
        """Request the follower, if the service is available."""
        if self.spawner.service_is_ready():
            self.answer = self.spawner.call_async(Spawn.Request(x=4.0, y=2.0, theta=0.0, name=FOLLOWER))
        else:
            self.get_logger().info("Service is not ready")

    def look_up(self) -> TransformStamped:
        """Return the target's pose in the follower's frame."""
        return self.buffer.lookup_transform(FOLLOWER, self.target_frame, Time())

    def follow(self) -> None:
        """Command the follower towards the target."""
        try:
            follower_from_target = self.look_up()
        except TransformException as error:
            self.get_logger().info(f"Could not transform {FOLLOWER} to {self.target_frame}: {error}")
            return
        there = follower_from_target.transform.translation
        turn = TURN_GAIN * math.atan2(there.y, there.x)
        self.velocities.publish(SPEED_GAIN * math.hypot(there.x, there.y), turn)


def main(args: list[str] | None = None) -> int:
    """Follow until stopped; return the exit code."""
    expect_no_arguments(
        "turtle_tf2_listener",
        "Spawn turtle2, and drive it towards a frame: --ros-args -p target_frame:=turtle1.",
        args,
    )
    return run_program(args, lambda: spin_driver(FrameListener()))
