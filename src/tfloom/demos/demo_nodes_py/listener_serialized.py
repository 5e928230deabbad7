"""listener_serialized: log the serialized bytes of the talker's messages."""

from __future__ import annotations

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program

__all__ = ["SerializedSubscriber", "main"]


class SerializedSubscriber(Node):
    """Subscribes to chatter, and takes messages in serialized form."""

    def __init__(self) -> None:
        super().__init__("serialized_subscriber")
        self.subscription = self.create_subscription(String, "chatter", self.listener_callback, 10, raw=True)

    def listener_callback(self, msg: bytes) -> None:
        """Log a message: its header of four bytes and its CDR."""
        self.get_logger().info(f'I heard: "{msg!r}"')


def main(args: list[str] | None = None) -> int:
    """Log messages until stopped; return the exit code."""
    expect_no_arguments("listener_serialized", "Log the serialized messages on the topic chatter.", args)
    return run_program(args, lambda: spin(SerializedSubscriber()))
