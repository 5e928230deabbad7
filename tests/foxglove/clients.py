"""Clients of the bridge that speak the subprotocol `foxglove.sdk.v1`, and bridges to speak to."""

from __future__ import annotations

import json
import socket
import struct
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from ssl import SSLContext
from typing import Any

import pytest
from tests.conftest import TIMEOUT_S, Program
from tests.viewer.conftest import running_node, spinning
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from tfloom.foxglove.bridge import FoxgloveBridge
from tfloom.node.context.context import Context
from tfloom.node.node import Node

SUBPROTOCOL = "foxglove.sdk.v1"


class Client:
    """What Foxglove does: it notes all that a server sends."""

    def __init__(self, port: int, ssl: SSLContext | None = None) -> None:
        self.socket = connect(
            f"{'ws' if ssl is None else 'wss'}://127.0.0.1:{port}",
            ssl=ssl,
            open_timeout=5.0,
            close_timeout=1.0,
            subprotocols=[SUBPROTOCOL],
            max_size=None,
            proxy=None,
            ping_interval=None,
        )  # type: ignore[list-item]
        self.bridge: Any = None
        """The bridge, if `connect_to` has connected it to one of this process."""
        self.info: dict[str, Any] = {}
        self.channels: dict[str, dict[str, Any]] = {}
        self.services: dict[str, dict[str, Any]] = {}
        self._subscriptions: dict[int, str] = {}
        """Topic of each subscription."""
        self.texts: list[dict[str, Any]] = []
        self.messages: list[tuple[int, bytes]] = []
        """Subscription and bytes of each message."""
        self.responses: dict[int, tuple[str, bytes]] = {}
        """Encoding and bytes of each service's response, by the id of the call."""
        self.assets: dict[int, tuple[int, str, bytes]] = {}
        """Status, error and bytes of each file."""
        self.times: list[int] = []

    def send(self, **message: Any) -> None:
        self.socket.send(json.dumps(message))

    def wait_for(self, condition: Callable[[], Any], what: str = "") -> Any:
        end_s = time.monotonic() + TIMEOUT_S
        while not (value := condition()):
            assert time.monotonic() < end_s, (
                f"timed out waiting for {what}; {len(self.messages)} messages came, and at last {self.texts[-5:]}"
            )
            try:
                self.take(self.socket.recv(timeout=0.05))
            except TimeoutError:
                continue
        return value

    def take(self, message: str | bytes) -> None:
        if isinstance(message, bytes):
            self.take_bytes(message)
            return
        said = json.loads(message)
        match said["op"]:
            case "serverInfo":
                self.info = said
            case "advertise":
                self.channels |= {channel["topic"]: channel for channel in said["channels"]}
            case "unadvertise":
                gone = set(said["channelIds"])
                self.channels = {name: one for name, one in self.channels.items() if one["id"] not in gone}
            case "advertiseServices":
                self.services |= {service["name"]: service for service in said["services"]}
            case "unadvertiseServices":
                gone = set(said["serviceIds"])
                self.services = {name: one for name, one in self.services.items() if one["id"] not in gone}
            case "status" if said["message"].startswith("Unknown channel ID: "):
                self._subscribe_again(int(said["message"].rpartition(" ")[2]))
                self.texts.append(said)
            case _:
                self.texts.append(said)

    def take_bytes(self, data: bytes) -> None:
        match data[0]:
            case 1:
                subscription, _ = struct.unpack_from("<IQ", data, 1)
                self.messages.append((subscription, data[13:]))
            case 2:
                self.times.append(struct.unpack_from("<Q", data, 1)[0])
            case 3:
                _, call, length = struct.unpack_from("<III", data, 1)
                self.responses[call] = data[13 : 13 + length].decode(), data[13 + length :]
            case 4:
                request, status, length = struct.unpack_from("<IBI", data, 1)
                self.assets[request] = status, data[10 : 10 + length].decode(), data[10 + length :]

    def _subscribe_again(self, channel: int) -> None:
        """Subscribe again to a channel that the SDK doesn't know yet: it advertises one just before, to new clients."""
        for subscription, topic in self._subscriptions.items():
            if topic in self.channels and self.channels[topic]["id"] == channel:
                self.send(op="subscribe", subscriptions=[{"id": subscription, "channelId": channel}])

    def subscribe(self, topic: str, subscription: int) -> None:
        self._subscriptions[subscription] = topic
        channel = self.wait_for(lambda: self.channels.get(topic), topic)
        self.send(op="subscribe", subscriptions=[{"id": subscription, "channelId": channel["id"]}])

    def advertise(self, channel: int, topic: str, schema: str, encoding: str = "cdr") -> None:
        self.send(
            op="advertise",
            channels=[{"id": channel, "topic": topic, "encoding": encoding, "schemaName": schema}],
        )

    def publish(self, channel: int, data: bytes) -> None:
        self.socket.send(b"\x01" + struct.pack("<I", channel) + data)

    def call(self, name: str, call: int, data: bytes, encoding: str = "cdr") -> None:
        service = self.wait_for(lambda: self.services.get(name), name)
        head = struct.pack("<III", service["id"], call, len(encoding))
        self.socket.send(b"\x02" + head + encoding.encode() + data)

    def text(self, op: str, **parts: Any) -> dict[str, Any]:
        """Wait for a message of one kind, with parts of these values, and return it."""

        def match() -> Any:
            return next(
                (said for said in self.texts if said["op"] == op and parts.items() <= said.items()), None
            )

        said: dict[str, Any] = self.wait_for(match, op)
        return said

    def is_closed(self) -> bool:
        """Take what has come, and return whether the bridge has closed the connection."""
        try:
            self.take(self.socket.recv(timeout=0.05))
        except TimeoutError:
            return False
        except ConnectionClosed:
            return True
        return False

    def statuses(self) -> str:
        return " ".join(said["message"] for said in self.texts if said["op"] == "status")


class RawClient:
    """A client of bytes: it sends what a WebSocket's library would not, and reads only when it is told to."""

    def __init__(self, port: int, *, is_silent: bool = False) -> None:
        self.socket = socket.socket()
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        self.socket.settimeout(TIMEOUT_S)
        self.socket.connect(("127.0.0.1", port))
        self.received = b""
        if is_silent:
            return
        lines = (
            "GET / HTTP/1.1",
            "Host: 127.0.0.1",
            "Upgrade: websocket",
            "Connection: Upgrade",
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
            "Sec-WebSocket-Version: 13",
            f"Sec-WebSocket-Protocol: {SUBPROTOCOL}",
        )
        self.socket.sendall("\r\n".join((*lines, "", "")).encode())

    def read_until(self, text: bytes) -> None:
        end_s = time.monotonic() + TIMEOUT_S
        while text not in self.received:
            assert time.monotonic() < end_s, self.received[-1000:]
            data = self.socket.recv(65536)
            if not data:
                raise ConnectionError("the bridge closed the connection")
            self.received += data

    def send_frame(self, opcode: int, data: bytes, length: int | None = None) -> None:
        """Send a masked frame; with `length`, one that declares another length than it has."""
        length = len(data) if length is None else length
        if length < 126:
            head = struct.pack("!BB", 0x80 | opcode, 0x80 | length)
        elif length < 65536:
            head = struct.pack("!BBH", 0x80 | opcode, 0x80 | 126, length)
        else:
            head = struct.pack("!BBQ", 0x80 | opcode, 0x80 | 127, length)
        self.socket.sendall(head + bytes(4) + data)

    def send(self, **message: Any) -> None:
        self.send_frame(1, json.dumps(message).encode())

    def subscribe(self, topic: str, subscription: int) -> None:
        name = json.dumps(topic).encode()
        self.read_until(b'"topic":' + name)
        before = self.received[: self.received.index(b'"topic":' + name)]
        channel = int(before[before.rindex(b'"id":') + 5 :].partition(b",")[0])
        self.send(op="subscribe", subscriptions=[{"id": subscription, "channelId": channel}])


@contextmanager
def bridging(domain_id: int, *parameters: str) -> Iterator[FoxgloveBridge]:
    """Run a bridge on a thread for the block, with its own context."""
    context = Context()
    words = [word for text in ("port:=0", *parameters) for word in ("-p", text)]
    context.init(args=["--ros-args", *words], domain_id=domain_id)
    try:
        bridge = FoxgloveBridge(context)
        try:
            with spinning(bridge):
                yield bridge
        finally:
            bridge.close()
    finally:
        context.try_shutdown()


@contextmanager
def spun_node(domain_id: int, name: str) -> Iterator[Node]:
    """Run another node of the graph on a thread for the block."""
    with running_node(domain_id, name) as node, spinning(node):
        yield node


def connect_to(bridge: FoxgloveBridge) -> Client:
    assert bridge.server is not None
    client = Client(bridge.port)
    client.bridge = bridge
    client.wait_for(lambda: client.info, "serverInfo")
    return client


@contextmanager
def connected(domain_id: int, *parameters: str) -> Iterator[Client]:
    """Run a bridge for the block, as `bridging` does, with a client that is connected to it."""
    with bridging(domain_id, *parameters) as bridge:
        client = connect_to(bridge)
        with closing(client.socket):
            yield client


def expect_refusal(domain_id: int, error: type[Exception], text: str, *parameters: str) -> None:
    """Check that a bridge with these parameters does not start, and that its error has a text."""
    with pytest.raises(error, match=text), bridging(domain_id, *parameters):
        pass


def port_of(program: Program) -> int:
    """Wait until a bridge serves, and return its port."""
    return int(program.wait_for("Server listening at ws").rpartition(":")[2])


def start_bridge_by(start_program: Callable[..., Program], *parameters: str) -> tuple[Program, int]:
    """Start a bridge as a process, with parameters, and return it with its port when it serves."""
    words = [word for text in ("port:=0", *parameters) for word in ("-p", text)]
    program = start_program("tfloom", "run", "foxglove_bridge", "foxglove_bridge", "--ros-args", *words)
    return program, port_of(program)
