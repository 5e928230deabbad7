"""What the ports of both wires do with the bytes that a page in a browser can send to them."""

from __future__ import annotations

import os
import re
import socket
from collections.abc import Callable
from contextlib import suppress

import psutil
import pytest
from tests.conftest import Program
from tests.viewer.open_ports import EVIL, open_ports
from tests.zenoh_ports import NEEDS_ZENOH, use_port_of

HEADERS = f"Host: 127.0.0.1\r\nOrigin: {EVIL}\r\n"
WEBSOCKET = (
    f"GET / HTTP/1.1\r\n{HEADERS}Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
).encode()
INIT = bytes.fromhex("0a00 01 09 c7 00112233445566".replace(" ", ""))
"""The begin of Zenoh's own conversation, as a page can only send it after a request's head."""
CLOSE = bytes.fromhex("02000302")
"""Zenoh's word that a connection is closed, because what came on it is invalid."""
REQUESTS = {
    "WebSocket": WEBSOCKET,
    "form": f"POST / HTTP/1.1\r\n{HEADERS}Content-Length: 65536\r\n\r\n".encode() + INIT * 5000,
    "TLS": bytes.fromhex("1603010200010001fc0303") + os.urandom(600),
}
STUN = bytes.fromhex("000100002112a442") + bytes(12)
"""What WebRTC sends to any address that a page names."""
QUIC = bytes.fromhex("c000000001") + os.urandom(1195)
"""How HTTP/3 and WebTransport begin."""


def start_talker(start_program: Callable[..., Program]) -> Program:
    talker = start_program("tfloom", "run", "demo_nodes_py", "talker")
    talker.wait_for("Publishing")
    return talker


def check_it_goes_on(talker: Program) -> None:
    numbers = [int(number) for number in re.findall(r"Hello World: (\d+)", talker.output)]
    talker.wait_for(f'Hello World: {numbers[-1] + 2}"')
    assert talker.process.poll() is None
    assert "Traceback" not in talker.output


@NEEDS_ZENOH
def test_pages_get_into_no_session_of_zenoh(
    domain_id: int, start_program: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page's first bytes are HTTP's or TLS's, and Zenoh's never begin so."""
    with use_port_of(domain_id) as router:
        monkeypatch.setenv("RMW_IMPLEMENTATION", "rmw_zenoh_cpp")
        talker = start_talker(start_program)
        ports = open_ports(talker.process.pid)
        assert ("127.0.0.1", router) in ports
        assert all(host == "127.0.0.1" for host, _ in ports)
        for port in ports:
            for name, request in REQUESTS.items():
                answer = b""
                with suppress(OSError), socket.create_connection(port, timeout=10.0) as page:
                    page.sendall(request)
                    page.settimeout(0.5)
                    answer = page.recv(4096)
                assert answer in {b"", CLOSE}, (port, name)
        check_it_goes_on(talker)


@pytest.mark.wire
def test_pages_get_no_word_from_dds(domain_id: int, start_program: Callable[..., Program]) -> None:
    """No program on DDS listens by TCP; by UDP, browsers send STUN and QUIC alone, which begin as no packet of DDS."""
    assert domain_id
    talker = start_talker(start_program)
    assert open_ports(talker.process.pid) == set()
    ports = {
        int(one.laddr.port) for one in psutil.Process(talker.process.pid).net_connections("udp4") if one.laddr
    }
    assert ports
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as page:
        page.settimeout(0.5)
        for port in ports:
            for packet in (STUN, QUIC):
                page.sendto(packet, ("127.0.0.1", port))
        with pytest.raises(TimeoutError):
            page.recv(4096)
    check_it_goes_on(talker)
