"""Spin a node with a drop-in listener until Ctrl-C, as a user's program does."""

from __future__ import annotations

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

from tfloom.drop_in import Buffer, TransformListener


class Follower(Node):
    def __init__(self) -> None:
        super().__init__("follower")
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.create_timer(0.01, self.look_up)
        self.is_ready = False

    def look_up(self) -> None:
        if not self.is_ready and self.tf_buffer.can_transform("world", "turtle", rclpy.time.Time()):
            self.is_ready = True
            print("found", flush=True)


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Follower())
    except (KeyboardInterrupt, ExternalShutdownException):
        print("ended", flush=True)


if __name__ == "__main__":
    main()
