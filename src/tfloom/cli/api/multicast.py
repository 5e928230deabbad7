"""The functions of `ros2multicast.api`: send and receive a datagram of UDP multicast."""

from __future__ import annotations

from tfloom.cli.multicast import GROUP, PORT, receive, send

__all__ = ["DEFAULT_GROUP", "DEFAULT_PORT", "receive", "send"]

DEFAULT_GROUP = GROUP
DEFAULT_PORT = PORT
