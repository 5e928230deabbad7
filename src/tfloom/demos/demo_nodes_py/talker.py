"""talker: publish a greeting once a second."""

from __future__ import annotations

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["Talker", "main"]

PERIOD_S = 1.0


class Talker(Node):
    """Publishes on chatter, with an increasing number."""

    def __init__(self) -> None:
        super().__init__("talker")
        self.i = 0
        self.pub = self.create_publisher(String, "chatter", 10)
        self.tmr = self.create_timer(PERIOD_S, self.timer_callback)

    def timer_callback(self) -> None:
        """Publish the next message."""
        message = String(data=f"Hello World: {self.i}")
        self.i += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.pub.publish(message)


def main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    expect_no_arguments("talker", "Publish a greeting on the topic chatter, once a second.", args)
    return run_program(args, lambda: spin(Talker()))
