"""Which pages reach foxglove_bridge, by its own port and by the SDK's behind it."""

from __future__ import annotations

import socket
from collections.abc import Callable, Iterator
from contextlib import closing
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.foxglove.clients import SUBPROTOCOL, TIMEOUT_S, bridging, connect_to, expect_refusal
from tests.viewer.open_ports import EVIL, answers_to_a_page, open_ports
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from tfloom.common.inner_port import InnerPort
from tfloom.foxglove.bridge import OPEN_INSIDE, FoxgloveBridge
from tfloom.foxglove.settings import SettingsError
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.node.node import Node
from tfloom.rosidl import cdr

pytestmark = pytest.mark.wire
StartBridge = Callable[..., tuple[Program, int]]


def status(port: int, **headers: str) -> int:
    """Return the status that a request for a WebSocket gets; 101 if it is opened."""
    host = headers.pop("Host", None)
    try:
        with connect(
            f"ws://{host or '127.0.0.1'}:{port}",
            sock=socket.create_connection(("127.0.0.1", port), timeout=TIMEOUT_S),
            additional_headers=headers,
            subprotocols=[SUBPROTOCOL],  # type: ignore[list-item]
            proxy=None,
        ) as opened:
            assert "serverInfo" in str(opened.recv(timeout=TIMEOUT_S))
    except InvalidStatus as error:
        return int(error.response.status_code)
    return 101


@pytest.fixture
def bridge(domain_id: int) -> Iterator[FoxgloveBridge]:
    with bridging(domain_id) as made:
        yield made


def test_pages_of_other_sites_are_refused(bridge: FoxgloveBridge, capfd: pytest.CaptureFixture[str]) -> None:
    port = bridge.port
    assert status(port) == 101  # a program
    for origin in (
        "https://app.foxglove.dev",
        "file://",
        f"http://127.0.0.1:{port}",
        "http://localhost:8080",
    ):
        assert status(port, Origin=origin) == 101, origin
    for origin in (EVIL, "null", "http://app.foxglove.dev", "https://app.foxglove.dev.evil.example"):
        assert status(port, Origin=origin) == 403, origin
        assert status(port, oRiGiN=origin) == 403, origin
    assert status(port, Host="rebound.evil.example") == 403
    assert status(port, Host="rebound.evil.example", Origin="https://app.foxglove.dev") == 403
    assert status(port, Origin=EVIL) == 403
    # Each reason is told once, and then clients connect as before.
    said = capfd.readouterr().err
    assert said.count(f"A connection is refused: pages of {EVIL} may not connect: allowed_origins") == 1
    assert status(port) == 101


def test_reasons_that_are_told_are_limited(
    bridge: FoxgloveBridge, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """A site has as many names as it likes."""
    monkeypatch.setattr("tfloom.foxglove.bridge.MAX_REFUSALS", 3)
    for number in range(6):
        assert status(bridge.port, Origin=f"https://{number}.evil.example") == 403
    assert capfd.readouterr().err.count("A connection is refused") == 3


def test_refused_page_moves_nothing(node: Node, bridge: FoxgloveBridge) -> None:
    got: list[float] = []
    node.create_subscription(Twist, "/cmd_vel", lambda message: got.append(message.linear.x), 10)
    with pytest.raises(InvalidStatus, match="403"):
        connect(
            f"ws://127.0.0.1:{bridge.port}",
            origin=EVIL,  # type: ignore[arg-type]
            subprotocols=[SUBPROTOCOL],  # type: ignore[list-item]
            proxy=None,
        )
    client = connect_to(bridge)
    with closing(client.socket):
        client.advertise(1, "/cmd_vel", "geometry_msgs/msg/Twist")
        wait_until(lambda: node.count_publishers("/cmd_vel") == 1)
        twist = Twist()
        twist.linear.x = 1.0
        wait_until(lambda: client.publish(1, cdr.encode(twist)) or got)
    assert set(got) == {1.0}


def test_sites_are_given_by_a_parameter(domain_id: int) -> None:
    with bridging(domain_id, "allowed_origins:=['https://Viewer.example:8443']") as bridge:
        assert status(bridge.port, Origin="https://viewer.example:8443") == 101
        assert status(bridge.port, Origin="http://localhost:1") == 101
        for origin in ("https://viewer.example", "https://app.foxglove.dev", "file://", "null"):
            assert status(bridge.port, Origin=origin) == 403
    for wrong in ("null", "'*'", "https://viewer.example/", "https://viewer.example:443", "viewer.example"):
        text = (
            r"parameter allowed_origins: '.*' is not a site as browsers name it, as https://viewer\.example"
        )
        expect_refusal(domain_id, SettingsError, text, f"allowed_origins:=[{wrong}]")


def test_no_port_of_the_process_lets_a_page_in(start_bridge: StartBridge) -> None:
    """The SDK itself lets all in: nobody but the relay gets as far as its port."""
    program, port = start_bridge()
    answers = {
        address: answers_to_a_page(address, "/", SUBPROTOCOL) for address in open_ports(program.process.pid)
    }
    assert answers.pop(("127.0.0.1", port))[0].startswith(b"HTTP/1.1 403")
    assert list(answers.values()) == [[]], "the SDK's port, and no other one"
    assert OPEN_INSIDE not in program.output
    assert status(port) == 101


@pytest.mark.parametrize("is_refused", [True, False])
def test_port_that_stays_open_is_told(
    is_refused: bool, domain_id: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """As on other systems than Linux, and in a sandbox that refuses filters, or takes them without effect."""

    def filter_without_effect(_: InnerPort) -> None:
        if is_refused:
            raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(InnerPort, "_filter", filter_without_effect)
    with bridging(domain_id) as bridge:
        assert OPEN_INSIDE in capfd.readouterr().err
        assert status(bridge.port) == 101
        assert status(bridge.port, Origin=EVIL) == 403


def test_system_without_filters(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.platform", "darwin")
    inner = InnerPort()
    assert inner.host == "127.0.0.1"
    assert not inner.close_to_others(1)


def test_addresses_of_two_bridges_differ() -> None:
    ports = [InnerPort() for _ in range(8)]
    assert len({one.host for one in ports} | {one._source for one in ports}) == 16


def test_inner_port_of_a_listener_that_is_not_there() -> None:
    inner: Any = InnerPort()
    inner.port = 1
    with pytest.raises(OSError, match="no socket listens at 127"):
        inner._listener()
