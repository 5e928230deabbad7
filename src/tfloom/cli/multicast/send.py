"""Send one UDP multicast datagram, on this machine, or on the subnet if the discovery range includes it."""

from __future__ import annotations

import argparse
import socket

from tfloom.cli.multicast.datagrams import GROUP, PORT, interface, udp_socket
from tfloom.cli.multicast.datagrams import add_arguments as add_common_arguments
from tfloom.cli.shared.errors import CommandError

TEXT = b"Hello World!"


def add_arguments(parser: argparse.ArgumentParser) -> None:
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


def main(args: argparse.Namespace) -> int:
    """Send the datagram; `multicast receive` prints it."""
    print("Sending one UDP multicast datagram...")
    try:
        send(TEXT, group=args.group, port=args.port, ttl=args.ttl)
    except OSError as error:
        raise CommandError(f"can't send to {args.group}:{args.port}: {error.strerror}") from None
    return 0


def send(data: bytes, *, group: str = GROUP, port: int = PORT, ttl: int | None = None) -> None:
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
