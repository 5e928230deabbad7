"""The ports of libraries that have no rules of who may connect, closed to all but this process."""

from __future__ import annotations

import array
import contextlib
import os
import secrets
import socket
import struct
import sys
from pathlib import Path

__all__ = ["InnerPort"]

BUFFER_BYTES = 256 * 1024
"""What the system may keep of a connection's bytes, about [bytes]: a client that falls behind gets that first, however
old it is."""
CONNECT_S = 0.05
"""How long a connection that is expected to fail is waited for [s]; one that is made takes microseconds."""
DESCRIPTORS = Path("/proc/self/fd")
SO_ATTACH_FILTER, SO_LOCK_FILTER = 26, 44
"""Linux's options of sockets, which Python doesn't name."""
SOURCE_ADDRESS = 0xFFF00000 + 12
"""Where a filter finds a packet's IPv4 address of the sender: SKF_NET_OFF, and its place in the header."""


class InnerPort:
    """An address for a server of a library, and the way to it.

    Browsers connect to addresses of the loopback interface from 127.0.0.1. On Linux all of 127.0.0.0/8 is this machine,
    so this process connects from a random one of these 16 million addresses, and a filter of the kernel on the
    server's socket drops each packet from another one: a page, whatever it tries, does not get as far as a connection.
    Other systems have no such filters.
    """

    def __init__(self) -> None:
        is_linux = sys.platform == "linux"
        self.host = _random_address() if is_linux else "127.0.0.1"
        """The address at which the library has to listen. Nobody knows it until `close_to_others` has been called."""
        self.port = 0
        self._source = _random_address() if is_linux else "127.0.0.1"

    def close_to_others(self, port: int) -> bool:
        """Close the port at which the library listens to all but this process; return whether nobody else gets in."""
        self.port = port
        if sys.platform != "linux":
            return False
        try:
            self._filter()
        except OSError:
            return False
        # A sandbox may take filters without effect: only a try shows that.
        return not self._lets_others_in()

    def _filter(self) -> None:
        with self._listener() as listener:
            (source,) = struct.unpack("!I", socket.inet_aton(self._source))
            code = array.array(
                "B",
                # Load the sender's address; if it is this process's, go on, else skip one; take all; take nothing.
                struct.pack("HBBI", 0x20, 0, 0, SOURCE_ADDRESS)
                + struct.pack("HBBI", 0x15, 0, 1, source)
                + struct.pack("HBBI", 0x06, 0, 0, 0xFFFFFFFF)
                + struct.pack("HBBI", 0x06, 0, 0, 0),
            )
            program = struct.pack("HP", len(code) // 8, code.buffer_info()[0])
            listener.setsockopt(socket.SOL_SOCKET, SO_ATTACH_FILTER, program)
            listener.setsockopt(socket.SOL_SOCKET, SO_LOCK_FILTER, 1)
            # Connections inherit these, too. A small message must not wait for the confirmation of the one before.
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER_BYTES)
            listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def _listener(self) -> socket.socket:
        """Return a copy of the listening socket, which libraries don't give away.

        Raises:
            OSError: this process has none.
        """
        for descriptor in DESCRIPTORS.iterdir():
            with contextlib.suppress(OSError):
                if not descriptor.is_socket():
                    continue
                copy = socket.socket(fileno=os.dup(int(descriptor.name)))
                if copy.family == socket.AF_INET and copy.getsockname() == (self.host, self.port):
                    return copy
                copy.close()
        raise OSError(f"no socket listens at {self.host}:{self.port}")

    def _lets_others_in(self) -> bool:
        with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as stranger:
            stranger.settimeout(CONNECT_S)
            try:
                stranger.connect(self.address)
            except OSError:
                return False
            return True

    def way_in(self) -> socket.socket:
        """Return a socket that may connect to `address`.

        Raises:
            OSError: the system gives none.
        """
        connection = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        try:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            connection.bind((self._source, 0))
        except BaseException:
            connection.close()
            raise
        return connection

    def connect(self, timeout_s: float) -> socket.socket:
        """Return a connection, which waits for as long as it takes.

        Raises:
            OSError: it can't be made in time.
        """
        connection = self.way_in()
        try:
            connection.settimeout(timeout_s)
            connection.connect(self.address)
            connection.settimeout(None)
        except BaseException:
            connection.close()
            raise
        return connection

    @property
    def address(self) -> tuple[str, int]:
        """Where the library listens."""
        return self.host, self.port


def _random_address() -> str:
    """Return a random address of the loopback interface that nothing else uses, as 127.0.0.1 and 127.0.1.1 are."""
    return f"127.{1 + secrets.randbelow(254)}.{secrets.randbelow(256)}.{secrets.randbelow(256)}"
