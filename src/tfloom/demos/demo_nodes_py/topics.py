"""Topics: talker and talker_qos publish a greeting once a second, and the listeners log it."""

from __future__ import annotations

import argparse
import sys

from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.client_library import ok, spin, spin_once
from tfloom.node.context.utilities import remove_ros_args
from tfloom.node.node import Node
from tfloom.node.program import expect_no_arguments, run_program
from tfloom.node.qos.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data

__all__ = [
    "Listener",
    "ListenerQos",
    "SerializedSubscriber",
    "Talker",
    "TalkerQos",
    "listener_main",
    "listener_qos_main",
    "listener_serialized_main",
    "parse_qos_arguments",
    "talker_main",
    "talker_qos_main",
]

CYCLES = 20


def parse_qos_arguments(
    program: str, description: str, what: str, args: list[str] | None
) -> tuple[QoSProfile, int]:
    """Read a command line; exit with a usage text if it is invalid.

    Args:
        program: The program's name.
        description: What it does.
        what: Name of the counted items, in the plural.
        args: Its command line, ROS arguments included; None: `sys.argv`.

    Returns:
        The quality of service, reliable or best effort, and the number to end after.
    """
    parser = argparse.ArgumentParser(prog=program, description=description)
    parser.add_argument("--reliable", action="store_true", help="be reliable (default: best effort)")
    parser.add_argument(
        *("-n", "--number_of_cycles"),
        type=int,
        default=CYCLES,
        metavar="N",
        help=f"end after this number of {what} (default: {CYCLES})",
    )
    options = parser.parse_args(remove_ros_args(sys.argv[1:] if args is None else args))
    reliable = QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE)
    return reliable if options.reliable else qos_profile_sensor_data, options.number_of_cycles


class Listener(Node):
    """Subscribes to chatter."""

    def __init__(self) -> None:
        super().__init__("listener")
        self.sub = self.create_subscription(String, "chatter", self.chatter_callback, 10)

    def chatter_callback(self, msg: String) -> None:
        """Log a message."""
        self.get_logger().info(f"I heard: [{msg.data}]")


def listener_main(args: list[str] | None = None) -> int:
    """Log messages until stopped; return the exit code."""
    expect_no_arguments("listener", "Log the messages on the topic chatter.", args)
    return run_program(args, lambda: spin(Listener()))


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


def listener_qos_main(args: list[str] | None = None) -> int:
    """Log the requested number of messages, or until stopped; return the exit code."""
    profile, cycles = parse_qos_arguments(
        "listener_qos", "Log the messages on the topic chatter.", "messages", args
    )

    def listen() -> None:
        node = ListenerQos(profile)
        while ok() and node.heard < cycles:
            spin_once(node)

    return run_program(args, listen)


class SerializedSubscriber(Node):
    """Subscribes to chatter, and takes messages in serialized form."""

    def __init__(self) -> None:
        super().__init__("serialized_subscriber")
        self.subscription = self.create_subscription(String, "chatter", self.listener_callback, 10, raw=True)

    def listener_callback(self, msg: bytes) -> None:
        """Log a message: its header of four bytes and its CDR."""
        self.get_logger().info(f'I heard: "{msg!r}"')


def listener_serialized_main(args: list[str] | None = None) -> int:
    """Log messages until stopped; return the exit code."""
    expect_no_arguments("listener_serialized", "Log the serialized messages on the topic chatter.", args)
    return run_program(args, lambda: spin(SerializedSubscriber()))


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


def talker_main(args: list[str] | None = None) -> int:
    """Publish until stopped; return the exit code."""
    expect_no_arguments("talker", "Publish a greeting on the topic chatter, once a second.", args)
    return run_program(args, lambda: spin(Talker()))


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


def talker_qos_main(args: list[str] | None = None) -> int:
    """Publish the requested number of messages, or until stopped; return the exit code."""
    profile, cycles = parse_qos_arguments(
        "talker_qos", "Publish greetings on the topic chatter, once a second.", "messages", args
    )

    def talk() -> None:
        node = TalkerQos(profile)
        while ok() and node.i < cycles:
            spin_once(node)

    return run_program(args, talk)
