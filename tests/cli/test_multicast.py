"""`multicast`: one datagram from a process to another over the loopback interface."""

from __future__ import annotations

import re
import socket
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor, wait
from typing import Any

import pytest
import transcript
from tests.conftest import hold_domain

from tfloom.cli.multicast import interface


@pytest.fixture
def port() -> Iterator[str]:
    """Yield a port that no other test uses."""
    with hold_domain() as domain:
        yield str(49150 - domain)


def test_datagram_is_received(port: str, start_program: Callable[..., Any]) -> None:
    receiver = start_program("tfloom", "multicast", "receive", "--port", port, "--timeout", "30")
    receiver.wait_for("Waiting for UDP multicast datagram...")
    sent = transcript.run_here("multicast", "send", "--port", port, "--ttl", "0")
    assert (sent.text, sent.exit_code) == ("Sending one UDP multicast datagram...", 0)
    assert receiver.wait() == 0
    assert re.fullmatch(r"Received from 127\.0\.0\.1:\d+: 'Hello World!'", receiver.lines[1])


def test_datagrams_between_programs(port: str) -> None:
    from ros2multicast.api import DEFAULT_GROUP, DEFAULT_PORT, receive, send

    assert (DEFAULT_GROUP, DEFAULT_PORT) == ("225.0.0.1", 49150)
    with pytest.raises(TimeoutError):
        receive(port=int(port), timeout=0.05)
    with ThreadPoolExecutor(1) as pool:
        received = pool.submit(receive, port=int(port), timeout=30.0)
        while not received.done():  # a datagram that nobody listens to is lost
            send(b"hello", port=int(port), ttl=0)
            wait([received], 0.02)
    data, (host, _) = received.result()
    assert (data, host) == (b"hello", "127.0.0.1")


def test_missing_datagram_gives_an_error_message(port: str) -> None:
    answer = transcript.run_here("multicast", "receive", "--port", port, "--timeout", "0.2")
    assert (answer.text.splitlines()[1:], answer.exit_code) == (["no datagram arrived within 0.2 s"], 1)


def test_datagram_to_another_address_is_not_received(port: str, start_program: Callable[..., Any]) -> None:
    receiver = start_program("tfloom", "multicast", "receive", "--port", port, "--timeout", "1")
    receiver.wait_for("Waiting")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(b"no", ("127.0.0.1", int(port)))
    assert receiver.wait() == 1


@pytest.mark.parametrize(
    ("environment", "address"),
    [
        ({}, "127.0.0.1"),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}, "127.0.0.1"),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"}, "0.0.0.0"),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "ROS_LOCALHOST_ONLY": "1"}, "127.0.0.1"),
    ],
)
def test_interface_is_loopback_unless_the_discovery_range_is_wider(
    environment: dict[str, str], address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_AUTOMATIC_DISCOVERY_RANGE", raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert interface() == address


@pytest.mark.parametrize(
    "words",
    [
        ("send", "--group", "1.2.3.4"),
        ("send", "--ttl", "256"),
        ("receive", "--port", "0"),
        ("receive", "--group", "x"),
    ],
)
def test_invalid_addresses_and_ports_are_rejected(words: tuple[str, ...]) -> None:
    answer = transcript.run_here("multicast", *words)
    assert answer.exit_code == 2
    assert "must be" in answer.text
