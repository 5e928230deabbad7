"""listener_qos: a listener with a chosen reliability that ends after a number of messages."""

from __future__ import annotations

from tfloom.demos.demo_nodes_py.qos_arguments import parse_qos_arguments
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import ok, spin_once
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy

__all__ = ["ListenerQos", "main"]


class ListenerQos(Node):
    """Subscribes to chatter.

    Args:
        qos_profile: The requested quality of service.
    """

    def __init__(self, qos_profile: QoSProfile) -> None:
        super().__init__("listener_qos")
        self.heard = 0
        is_reliable = qos_profile.reliability is ReliabilityPolicy.RELIABLE
        self.get_logger().info("Reliable listener" if is_reliable else "Best effort listener")
        self.sub = self.create_subscription(String, "chatter", self.chatter_callback, qos_profile)

    def chatter_callback(self, msg: String) -> None:
        """Count a message, and log its text."""
        self.heard += 1
        self.get_logger().info(f"I heard: [{msg.data}]")


def main(args: list[str] | None = None) -> int:
    """Log the requested number of messages, or until stopped; return the exit code."""
    profile, cycles = parse_qos_arguments(
        "listener_qos", "Log the messages on the topic chatter.", "messages", args
    )

    def listen() -> None:
        node = ListenerQos(profile)
        while ok() and node.heard < cycles:
            spin_once(node)

    return run_program(args, listen)
