"""The group, the port and the range of a datagram of UDP multicast."""

from __future__ import annotations

import argparse
import ipaddress
import os
import socket

from tfloom.cli.shared.errors import CommandError
from tfloom.rmw.cyclone.config import DEFAULT_RANGE

GROUP = "225.0.0.1"
PORT = 49150
MAX_DATAGRAM_SIZE = 4096
"""The largest datagram that is read [bytes]."""
LOOPBACK = "127.0.0.1"
ANY = "0.0.0.0"  # noqa: S104  # the interface that the system chooses


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags of both."""
    parser.add_argument(
        "--group", type=_group, default=GROUP, help=f"IPv4 multicast address (default: {GROUP})"
    )
    parser.add_argument("--port", type=_port, default=PORT, help=f"UDP port (default: {PORT})")


def interface() -> str:
    """Return the address of the interface to use: the loopback's, unless the discovery range is wider."""
    asked = os.environ.get("ROS_AUTOMATIC_DISCOVERY_RANGE") or DEFAULT_RANGE
    if os.environ.get("ROS_LOCALHOST_ONLY") == "1" or asked not in {"SUBNET", "SYSTEM_DEFAULT"}:
        return LOOPBACK
    return ANY


def udp_socket() -> socket.socket:
    """Return a UDP socket.

    Raises:
        CommandError: the system refuses it.
    """
    try:
        return socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    except OSError as error:
        raise CommandError(f"can't open a UDP socket: {error.strerror}") from None


def _group(text: str) -> str:
    try:
        is_group = ipaddress.IPv4Address(text).is_multicast
    except ValueError:
        is_group = False
    if not is_group:
        raise argparse.ArgumentTypeError(
            f"must be an address from 224.0.0.0 to 239.255.255.255, not {text!r}"
        )
    return text


def _port(text: str) -> int:
    port = int(text) if text.isascii() and text.isdigit() else 0
    if not 1 <= port <= 65535:
        raise argparse.ArgumentTypeError(f"must be a number from 1 to 65535, not {text!r}")
    return port
