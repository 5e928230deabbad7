"""Receive one UDP multicast datagram, of this machine, or of the subnet if the discovery range includes it."""

from __future__ import annotations

import argparse
import os
import socket
import sys

from tfloom.cli.multicast.datagrams import GROUP, MAX_DATAGRAM_SIZE, PORT, interface, udp_socket
from tfloom.cli.multicast.datagrams import add_arguments as add_common_arguments
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import seconds

IP_MULTICAST_ALL = 49
"""Linux: 0 excludes the memberships of other sockets on other interfaces."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `multicast receive`."""
    add_common_arguments(parser)
    parser.add_argument("--timeout", type=seconds, help="longest wait in seconds (default: until Ctrl-C)")


def main(args: argparse.Namespace) -> int:
    """Wait for the datagram and print its sender and its text."""
    with udp_socket() as receiver:
        try:
            _join(receiver, args.group, args.port)
        except OSError as error:
            raise CommandError(f"can't listen to {args.group}:{args.port}: {error.strerror}") from None
        print("Waiting for UDP multicast datagram...")
        receiver.settimeout(args.timeout)
        try:
            data, (host, port) = receiver.recvfrom(MAX_DATAGRAM_SIZE)
        except (TimeoutError, BlockingIOError):
            raise CommandError(f"no datagram arrived within {args.timeout:g} s") from None
    print(f"Received from {host}:{port}: {data.decode('utf-8', 'backslashreplace')!r}")
    return 0


def receive(
    *, group: str = GROUP, port: int = PORT, timeout: float | None = None
) -> tuple[bytes, tuple[str, int]]:
    """Return the bytes of the next datagram, and the address and port of its sender.

    Args:
        group: IPv4 multicast address.
        port: UDP port.
        timeout: Longest wait [s]; None for ever.

    Raises:
        TimeoutError: none arrived within the timeout.
        OSError: the system refuses to listen.
    """
    with udp_socket() as receiver:
        _join(receiver, group, port)
        receiver.settimeout(timeout)
        data, (host, sender_port) = receiver.recvfrom(MAX_DATAGRAM_SIZE)
        return data, (host, sender_port)


def _join(receiver: socket.socket, group: str, port: int) -> None:
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    # Bound to the group, it receives nothing that was sent to this machine alone; Windows can't.
    receiver.bind((group if os.name == "posix" else "", port))
    if sys.platform == "linux":
        receiver.setsockopt(socket.IPPROTO_IP, IP_MULTICAST_ALL, 0)
    membership = socket.inet_aton(group) + socket.inet_aton(interface())
    receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
