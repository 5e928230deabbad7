"""talker: publish a greeting once a second, counted from 1."""

from __future__ import annotations

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["Talker", "main"]

PERIOD_S = 1.0
DEPTH = 7


class Talker(Node):
    """Publishes on chatter, with an increasing number."""

    def __init__(self) -> None:
        super().__init__("talker")
        self._count = 1
        self._publisher = self.create_publisher(String, "chatter", DEPTH)
        self.create_timer(PERIOD_S, self._publish)

    def _publish(self) -> None:
        message = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f"Publishing: '{message.data}'")
        self._publisher.publish(message)


def main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    expect_no_arguments("talker", "Publish a greeting on the topic chatter, once a second.", args)
    return run_program(args, lambda: spin(Talker()))
