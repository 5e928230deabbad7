"""Wait for one message without a callback."""

from __future__ import annotations

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


def wait(node: Node, seconds: float = 10.0) -> bool:
    """Log the next message of /chatter; return False if none is received in time."""
    found, message = wait_for_message(String, node, "chatter", time_to_wait=seconds)
    if found:
        node.get_logger().info(f"The next words: {message.data}")
    else:
        node.get_logger().error(f"Nobody said anything for {seconds} s")
    return found


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        return 0 if wait(Node("waiter")) or not rclpy.ok() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
