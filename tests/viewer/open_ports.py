"""The ports at which a process listens, and what they answer to a page of another site."""

from __future__ import annotations

import socket
import ssl
from contextlib import suppress

import psutil

EVIL = "https://evil.example"
CONNECT_S = 0.5
"""How long a connection that should fail is waited for [s]; one that is made takes microseconds."""
TIMEOUT_S = 30.0


def open_ports(pid: int) -> set[tuple[str, int]]:
    """Return the addresses and ports at which a process and those that it has started listen, by TCP."""
    process = psutil.Process(pid)
    return {
        (str(connection.laddr.ip), int(connection.laddr.port))
        for member in (process, *process.children(recursive=True))
        for connection in member.net_connections("tcp")
        if connection.status == psutil.CONN_LISTEN
    }


def answers_to_a_page(address: tuple[str, int], path: str, subprotocol: str) -> list[bytes]:
    """Return what comes when a page of another site tries to open a WebSocket, in clear and encrypted."""
    request = (
        f"GET {path} HTTP/1.1\r\nHost: {address[0]}:{address[1]}\r\nOrigin: {EVIL}\r\n"
        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        f"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: {subprotocol}\r\n\r\n"
    ).encode()
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    answers = []
    for is_encrypted in (False, True):
        with suppress(OSError), socket.create_connection(address, timeout=CONNECT_S) as plain:
            plain.settimeout(TIMEOUT_S)
            connection = context.wrap_socket(plain) if is_encrypted else plain
            connection.sendall(request)
            answers.append(connection.recv(4096))
    return answers
