"""talker_qos: a talker with a chosen reliability that ends after a number of messages."""

from __future__ import annotations

from tfloom.demos.demo_nodes_py.qos_arguments import parse_qos_arguments
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import ok, spin_once
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy

__all__ = ["TalkerQos", "main"]

PERIOD_S = 1.0


class TalkerQos(Node):
    """Publishes on chatter, once a second.

    Args:
        qos_profile: The offered quality of service.
    """

    def __init__(self, qos_profile: QoSProfile) -> None:
        super().__init__("talker_qos")
        self.i = 0
        is_reliable = qos_profile.reliability is ReliabilityPolicy.RELIABLE
        self.get_logger().info("Reliable talker" if is_reliable else "Best effort talker")
        self.pub = self.create_publisher(String, "chatter", qos_profile)
        self.tmr = self.create_timer(PERIOD_S, self.timer_callback)

    def timer_callback(self) -> None:
        """Publish the next message."""
        message = String(data=f"Hello World: {self.i}")
        self.i += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.pub.publish(message)


def main(args: list[str] | None = None) -> int:
    """Publish the requested number of messages, or until stopped; return the exit code."""
    profile, cycles = parse_qos_arguments(
        "talker_qos", "Publish greetings on the topic chatter, once a second.", "messages", args
    )

    def talk() -> None:
        node = TalkerQos(profile)
        while ok() and node.i < cycles:
            spin_once(node)

    return run_program(args, talk)
