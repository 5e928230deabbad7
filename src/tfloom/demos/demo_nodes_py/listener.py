"""listener: log the talker's messages."""

from __future__ import annotations

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["Listener", "main"]


class Listener(Node):
    """Subscribes to chatter."""

    def __init__(self) -> None:
        super().__init__("listener")
        self.sub = self.create_subscription(String, "chatter", self.chatter_callback, 10)

    def chatter_callback(self, msg: String) -> None:
        """Log a message."""
        self.get_logger().info(f"I heard: [{msg.data}]")


def main(args: list[str] | None = None) -> int:
    """Log messages until stopped; return the exit code."""
    expect_no_arguments("listener", "Log the messages on the topic chatter.", args)
    return run_program(args, lambda: spin(Listener()))
