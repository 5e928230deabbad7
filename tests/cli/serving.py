"""The end of a program that serves: it says that it is ready, and spins until it is stopped."""

from __future__ import annotations

from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def serve(node: Node) -> None:
    """Print `ready`, and spin a node until Ctrl-C."""
    print("ready", flush=True)
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)
