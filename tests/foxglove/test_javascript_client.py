"""foxglove_bridge, to the JavaScript client of npm, which Foxglove's applications began with."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from tests.conftest import Program, run_to_end, wait_until
from tests.foxglove.clients import SUBPROTOCOL, TIMEOUT_S, bridging

from tfloom.foxglove.assets import read_asset
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.node.node import Node
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from collections.abc import Iterator

pytestmark = [pytest.mark.slow, pytest.mark.wire]
PACKAGES = ("@foxglove/ws-protocol@0.8.0", "ws@8")
INSTALL_S = 180.0
DRIVER = Path(__file__).with_name("ws_client.cjs")


@pytest.fixture(scope="module")
def node_modules(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which npm has installed the client and a WebSocket."""
    npm, node = shutil.which("npm"), shutil.which("node")
    if npm is None or node is None:
        pytest.skip("npm and node are not installed")
    folder = tmp_path_factory.mktemp("npm")
    command = [
        npm,
        "install",
        "--no-audit",
        "--no-fund",
        "--ignore-scripts",
        "--prefix",
        str(folder),
        *PACKAGES,
    ]
    try:
        done = run_to_end(command, cwd=folder, timeout_s=INSTALL_S)
    except subprocess.TimeoutExpired:
        pytest.skip(f"npm did not install {PACKAGES[0]} within {INSTALL_S:g} s")
    if done.returncode != 0:
        pytest.skip(f"npm can't install {PACKAGES[0]}: {' '.join(done.stderr.split())[:300]}")
    return folder / "node_modules"


class JavaScriptClient:
    """The client in a process of node's: it calls the client's methods, and reads the events."""

    def __init__(self, program: Program) -> None:
        self.program = program

    def call(self, method: str, *arguments: Any) -> None:
        self.program.process.stdin.write(json.dumps([method, *arguments]) + "\n")
        self.program.process.stdin.flush()

    def values(self, event: str) -> list[Any]:
        said = [json.loads(line) for line in list(self.program.lines) if line.startswith("{")]
        return [one.get("value") for one in said if one["event"] == event]

    def wait_for(self, condition: Callable[[], Any], what: str) -> Any:
        wait_until(condition, TIMEOUT_S)
        value = condition()
        assert value, f"{what}: {self.program.output[-2000:]}"
        return value

    def value(self, event: str, is_right: Callable[[Any], Any] = lambda _: True) -> Any:
        """Wait for an event with a value that is right, and return the value."""

        def find() -> list[Any]:
            return [value for value in self.values(event) if is_right(value)]

        return self.wait_for(find, event)[0]

    def named(self, event: str, key: str, name: str) -> dict[str, Any]:
        """Wait until a list of an event has an element of a name, and return the element."""

        def find() -> list[Any]:
            return [one for value in self.values(event) for one in value if one[key] == name]

        found: dict[str, Any] = self.wait_for(find, name)[-1]
        return found


@pytest.fixture
def open_client(
    node_modules: Path, start_program: Callable[..., Program], monkeypatch: pytest.MonkeyPatch
) -> Callable[..., JavaScriptClient]:
    monkeypatch.setenv("NODE_PATH", str(node_modules))

    def open_one(port: int, *subprotocols: str) -> JavaScriptClient:
        return JavaScriptClient(
            start_program("node", DRIVER, str(port), *subprotocols, stdin=subprocess.PIPE)
        )

    return open_one


@contextmanager
def _port(domain_id: int) -> Iterator[int]:
    with bridging(domain_id) as bridge:
        assert bridge.server is not None
        yield bridge.port


def _padded(data: bytes) -> bytes:
    """Return what DDS carries for data: it fills the last word with zeros."""
    return data + bytes(-len(data) % 4)


def test_messages_and_responses_arrive_as_they_were_sent(
    domain_id: int, node: Node, open_client: Callable[..., JavaScriptClient]
) -> None:
    def switch(request: Any, response: Any) -> Any:
        response.success, response.message = request.data, "switched"
        return response

    heard: list[bytes] = []
    publisher = node.create_publisher(MarkerArray, "/markers", 10)
    subscription = node.create_subscription(String, "/said", heard.append, 10, raw=True)
    node.create_service(SetBool, "/switch", switch)
    with _port(domain_id) as port:
        client = open_client(port, SUBPROTOCOL)
        assert client.value("serverInfo")["supportedEncodings"] == ["cdr"]

        channel = client.named("advertise", "topic", "/markers")
        assert (channel["encoding"], channel["schemaName"]) == ("cdr", "visualization_msgs/msg/MarkerArray")
        assert channel["schema"].startswith("Marker[] markers\n")

        asked = 0

        def is_subscribed() -> bool:
            nonlocal asked
            # The SDK can refuse a subscription: it advertises a channel just before it knows it.
            if asked <= len(client.values("status")):
                asked += 1
                client.call("subscribe", channel["id"])
            return publisher.get_subscription_count() == 1

        wait_until(is_subscribed, TIMEOUT_S)
        data = cdr.encode(MarkerArray(markers=[Marker(text="é", id=number) for number in range(3)]))
        publisher.publish(data)
        assert client.value("message")["data"] == _padded(data).hex()

        service = client.named("advertiseServices", "name", "/switch")
        request = cdr.encode(SetBool.Request(data=True))
        called = {"serviceId": service["id"], "callId": 8, "encoding": "cdr", "data": {"hex": request.hex()}}
        client.call("sendServiceCallRequest", called)
        response = client.value("serviceCallResponse")
        assert (response["callId"], response["encoding"]) == (8, "cdr")
        expected = cdr.encode(SetBool.Response(success=True, message="switched"))
        assert bytes.fromhex(response["data"]) == expected

        client.call("advertise", {"topic": "/said", "encoding": "cdr", "schemaName": "std_msgs/msg/String"})
        number = client.value("advertise()")
        wait_until(lambda: subscription.get_publisher_count() == 1)
        said = cdr.encode(String(data="by JavaScript: é"))
        client.call("sendMessage", number, {"hex": said.hex()})
        client.wait_for(lambda: heard, "the client's message")
        assert bytes(heard[0]) == _padded(said)


def test_parameters_graph_and_assets(
    domain_id: int,
    node: Node,
    open_client: Callable[..., JavaScriptClient],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (tmp_path / "link.stl").write_bytes(b"solid\x00\xff")
    monkeypatch.setattr(read_asset, "__defaults__", (lambda _: tmp_path,))
    node.declare_parameter("gain", 2.0)
    node.create_publisher(String, "/chatter", 1)
    with _port(domain_id) as port:
        client = open_client(port, SUBPROTOCOL)
        client.value("serverInfo")
        client.named("advertiseServices", "name", "/other/set_parameters")

        client.call("getParameters", ["/other.gain"], "got")
        got = client.value("parameterValues", lambda value: value.get("id") == "got" and value["parameters"])
        assert got["parameters"] == [{"name": "/other.gain", "value": 2, "type": "float64"}]
        client.call("setParameters", [{"name": "/other.gain", "value": 3.5, "type": "float64"}], "set")
        client.value("parameterValues", lambda value: value.get("id") == "set")
        assert node.get_parameter("gain").value == 3.5

        client.call("subscribeConnectionGraph")
        client.value(
            "connectionGraphUpdate",
            lambda value: {"name": "/chatter", "publisherIds": ["/other"]} in value["publishedTopics"],
        )

        client.call("fetchAsset", "package://arm/link.stl", 4)
        asset = client.value("fetchAssetResponse")
        assert (asset["requestId"], asset["data"]) == (4, b"solid\x00\xff".hex())


def test_subprotocol_that_the_client_names_by_default_is_refused(
    domain_id: int, open_client: Callable[..., JavaScriptClient]
) -> None:
    with _port(domain_id) as port:
        client = open_client(port)
        assert client.value("error") == "Unexpected server response: 400"
