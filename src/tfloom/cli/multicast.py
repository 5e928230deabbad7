"""`multicast`: send and receive one UDP multicast datagram.

It stays on this machine, or on the subnet if the discovery range includes it.
"""

from __future__ import annotations

import argparse
import ipaddress
import os
import socket
import sys

from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.numbers import seconds
from tfloom.rmw.cyclone.config import DEFAULT_RANGE

DEFAULT_GROUP = "225.0.0.1"
DEFAULT_PORT = 49150
MAX_DATAGRAM_SIZE = 4096
"""The largest datagram that is read [bytes]."""
LOOPBACK = "127.0.0.1"
ANY = "0.0.0.0"  # noqa: S104  # the interface that the system chooses


def add_common_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the flags of both."""
    parser.add_argument(
        "--group",
        type=_group,
        default=DEFAULT_GROUP,
        help=f"IPv4 multicast address (default: {DEFAULT_GROUP})",
    )
    parser.add_argument(
        "--port", type=_port, default=DEFAULT_PORT, help=f"UDP port (default: {DEFAULT_PORT})"
    )


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


IP_MULTICAST_ALL = 49
"""Linux: 0 excludes the memberships of other sockets on other interfaces."""


def add_receive_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `multicast receive`."""
    add_common_arguments(parser)
    parser.add_argument("--timeout", type=seconds, help="longest wait in seconds (default: until Ctrl-C)")


def receive_main(args: argparse.Namespace) -> int:
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
    *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, timeout: float | None = None
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


TEXT = b"Hello World!"


def add_send_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `multicast send`."""
    add_common_arguments(parser)
    parser.add_argument(
        "--ttl", type=_ttl, default=1, help="number of routers that it may cross, plus one (default: 1)"
    )


def _ttl(text: str) -> int:
    ttl = int(text) if text.isascii() and text.isdigit() else 256
    if ttl > 255:
        raise argparse.ArgumentTypeError(f"must be a number from 0 to 255, not {text!r}")
    return ttl


def send_main(args: argparse.Namespace) -> int:
    """Send the datagram; `multicast receive` prints it."""
    print("Sending one UDP multicast datagram...")
    try:
        send(TEXT, group=args.group, port=args.port, ttl=args.ttl)
    except OSError as error:
        raise CommandError(f"can't send to {args.group}:{args.port}: {error.strerror}") from None
    return 0


def send(
    data: bytes, *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, ttl: int | None = None
) -> None:
    """Send a datagram, on the interface of the discovery range.

    Args:
        data: Its bytes.
        group: IPv4 multicast address.
        port: UDP port.
        ttl: Number of routers that it may cross, plus one; None for 1.

    Raises:
        OSError: the system refuses it.
    """
    with udp_socket() as sender:
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1 if ttl is None else ttl)
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface()))
        sender.sendto(data, (group, port))
