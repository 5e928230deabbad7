"""foxglove_bridge, to clients that send what no client should."""

from __future__ import annotations

import json
import random
import struct
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from itertools import count
from typing import Any, NamedTuple

import psutil
import pytest
from tests.conftest import Program, wait_until
from tests.foxglove.clients import Client, RawClient, spun_node, start_bridge_by

from tfloom.foxglove import client_topics, parameters
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.endpoints.publisher import Publisher
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.node import Node
from tfloom.rosidl import cdr

pytestmark = pytest.mark.wire
MAX_GROWTH = 150_000_000
"""What a bridge may take more than before [bytes]."""
BINARY, TEXT = 2, 1


class Served(NamedTuple):
    """A bridge in a process, with a node that it serves."""

    program: Program
    port: int
    node: Node
    publisher: Publisher[String]
    """Of /chatter."""
    said: Subscription[String]
    """Of /said, which clients advertise."""
    heard: list[bytes]
    """What came on /said."""


@pytest.fixture(scope="module")
def bridge(module_domain_id: int, start_module_program: Callable[..., Program]) -> Iterator[Served]:
    """Serve a graph by one bridge, to the hostile clients of all tests."""
    with spun_node(module_domain_id, "other") as node:
        node.declare_parameter("count", 3)
        node.declare_parameter("names", ["a"])

        def switch(request: Any, response: Any) -> Any:
            response.success = request.data
            return response

        node.create_service(SetBool, "/switch", switch)
        heard: list[bytes] = []
        said = node.create_subscription(String, "/said", heard.append, 10, raw=True)
        publisher = node.create_publisher(String, "/chatter", 10)
        program, port = start_bridge_by(start_module_program)
        served = Served(program, port, node, publisher, said, heard)
        check_a_good_client(served)
        yield served


@pytest.fixture
def served(bridge: Served) -> Iterator[Served]:
    """Return the bridge; afterwards, a good client has to find all in order, and the memory and the log bounded."""
    program = bridge.program
    process = psutil.Process(program.process.pid)
    before, line_count = process.memory_info().rss, len(program.lines)
    bridge.heard.clear()
    yield bridge
    assert program.process.poll() is None, program.output
    check_a_good_client(bridge)
    assert process.memory_info().rss - before < MAX_GROWTH
    assert "Traceback" not in program.output
    assert "panicked" not in program.output
    assert len(program.lines) - line_count < 1000, "a client can fill the log"


def check_a_good_client(served: Served) -> None:
    """Check that a bridge serves a client as it should, as soon as what others advertised is gone, and this, too."""
    publisher = served.publisher
    wait_until(lambda: served.said.get_publisher_count() == 0, what="the end of what clients advertised")
    client = Client(served.port)
    with closing(client.socket):
        client.subscribe("/chatter", 1)

        def is_read() -> bool:
            return bool(publisher.get_subscription_count() == 1)

        client.wait_for(is_read, "the bridge's subscription")
        data = cdr.encode(String(data="number 0000"))
        assert len(data) % 4 == 0  # the wire adds nothing
        client.wait_for(lambda: publisher.publish(data) or (1, data) in client.messages, "the message")
        client.call("/switch", 2, cdr.encode(SetBool.Request(data=True)))
        client.wait_for(lambda: client.responses, "the response")
        client.advertise(3, "/said", "std_msgs/msg/String")
        said = cdr.encode(String(data="said 000000"))
        wait_until(lambda: served.node.count_publishers("/said") == 1)
        wait_until(lambda: client.publish(3, said) or said in [bytes(one) for one in served.heard])
        client.send(op="getParameters", parameterNames=["/other.count"], id="good")
        assert client.text("parameterValues", id="good")["parameters"] == [
            {"name": "/other.count", "value": 3}
        ]
    wait_until(lambda: served.said.get_publisher_count() == 0)


def send_all(served: Served, frames: list[tuple[int, bytes]]) -> None:
    """Send frames, each on its own connection, because the bridge may close it."""
    for opcode, data in frames:
        client = RawClient(served.port)
        with closing(client.socket), suppress(ConnectionError):
            client.send_frame(opcode, data)
            client.read_until(b"serverInfo")


def wait_for_status(client: Client, text: str, do_wrong: Callable[[], None]) -> None:
    """Do something wrong until a bridge says so, because it says only some of all that is wrong in a second."""
    client.wait_for(lambda: do_wrong() or text in client.statuses(), text)


def test_frames_that_are_none(served: Served) -> None:
    source = random.Random(32)
    for size in (1, 2, 7, 100, 5000):
        for _ in range(4):
            client = RawClient(served.port)
            with closing(client.socket), suppress(ConnectionError):
                client.read_until(b"serverInfo")
                client.socket.sendall(source.randbytes(size))
    for length in (2**31, 2**40, 2**62, 2**63):
        client = RawClient(served.port)
        with closing(client.socket), suppress(ConnectionError):
            client.send_frame(BINARY, b"\x01" + bytes(100), length)
    # A message as long as it says, of a client that advertised nothing.
    client = RawClient(served.port)
    with closing(client.socket), suppress(ConnectionError):
        client.send_frame(BINARY, b"\x01" + bytes(200_000_000))


def test_messages_of_no_known_kind(served: Served) -> None:
    binaries = [b"", b"\xff", b"\x00" * 20, b"\x01", b"\x01\x00", b"\x02\x00\x00", b"\x02" + b"\xff" * 12]
    texts: list[Any] = [
        *(None, 1, "text", [], {}, {"op": None}, {"op": "fly"}, {"op": ["subscribe"]}),
        {"op": "subscribe"},
        {"op": "subscribe", "subscriptions": None},
        {"op": "subscribe", "subscriptions": [{"id": "a", "channelId": -1}]},
        {"op": "unsubscribe", "subscriptionIds": [1, 2**40]},
        {"op": "advertise", "channels": [{"id": 1}]},
        {"op": "unadvertise", "channelIds": [7]},
        {"op": "getParameters", "parameterNames": "all"},
        {"op": "setParameters", "parameters": [{"value": 1}]},
        {"op": "fetchAsset", "uri": None, "requestId": 1},
        {"op": "subscribeParameterUpdates", "parameterNames": [None]},
    ]
    send_all(served, [(BINARY, data) for data in binaries])
    send_all(served, [(TEXT, json.dumps(text).encode()) for text in texts])
    send_all(served, [(TEXT, data) for data in (b"", b"{", b"\xff\xfe", b"[" * 100_000, b'{"op":' * 10_000)])
    send_all(served, [(opcode, b"x") for opcode in range(3, 16)])


def test_messages_that_are_none(served: Served) -> None:
    """Malformed messages, also many of them, don't reach other nodes, and don't fill the log."""
    source = random.Random(33)
    client = Client(served.port)
    with closing(client.socket):
        client.advertise(3, "/said", "std_msgs/msg/String")
        wait_until(lambda: served.node.count_publishers("/said") == 1)
        good = cdr.encode(String(data="a good text"))
        for number in range(3000):
            data = source.choice((b"", good[:-3], good[:4] + b"\xff\xff\xff\x7f", source.randbytes(9)))
            client.publish(99 if number % 1000 == 0 else 3, data)
        wait_for_status(client, "a message to /said can't be decoded", lambda: client.publish(3, b""))
        wait_until(lambda: client.publish(3, good) or served.heard)
        assert {bytes(data) for data in served.heard} == {good}


def test_parameters_of_wrong_types(served: Served) -> None:
    values: list[Any] = [
        *("text", True, [], {}, {"a": [1]}, [[1]], [{"b": 1}], 1.5, [1.5]),
        *(2**31, 2**63 - 1, 2**63, -(2**70), 1e308, "\x00", "x" * 1_000_000),
    ]
    names = [
        *("/other.count", "/other.names", "/other.none", "/other.", ".", "", "count"),
        *("/nobody.count", "/oth\x00.a"),
    ]
    client = Client(served.port)
    with closing(client.socket):
        ids = []
        for name in names:
            for value in values if name == "/other.count" else values[:4]:
                ids.append(str(len(ids)))
                client.send(op="setParameters", parameters=[{"name": name, "value": value}], id=ids[-1])
            for value in (None, [1, "a"], [None], "\ud800"):  # no values of parameters, so there is no answer
                client.send(op="setParameters", parameters=[{"name": name, "value": value}])
        for kind in ("byte_array", "float64", "float64_array", "fly"):
            for value in ("%%%", "AAAA", 1, [1]):
                client.send(
                    op="setParameters", parameters=[{"name": "/other.count", "value": value, "type": kind}]
                )
        client.send(op="getParameters", parameterNames=[*names, *("/other.x" * 5000,)], id="odd")
        wrong = [{"name": "/other.count", "value": "text"}]
        wait_for_status(
            client, "/other did not set count", lambda: client.send(op="setParameters", parameters=wrong)
        )
        client.text("parameterValues", id="odd")
        for request in ids:
            client.text("parameterValues", id=request)
    served.node.set_parameters([type(served.node.get_parameter("count"))("count", value=3)])


def test_many_subscriptions_topics_and_calls(served: Served) -> None:
    client = Client(served.port)
    with closing(client.socket):
        client.wait_for(lambda: "/chatter" in client.channels and "/switch" in client.services)
        chatter = client.channels["/chatter"]["id"]
        subscriptions = [{"id": number, "channelId": chatter} for number in range(1000)]
        wrong = [{"id": 2000 + number, "channelId": chatter + 1000 + number} for number in range(20)]
        for some in (subscriptions[:1], wrong, subscriptions[1:20]):
            client.send(op="subscribe", subscriptions=some)
        client.send(op="unsubscribe", subscriptionIds=[0, 5, 2**31])
        numbers = count()

        def advertise() -> None:
            number = next(numbers)
            client.advertise(number, f"/many/topic_{number}", "std_msgs/msg/String")

        for _ in range(256):
            advertise()
        wait_for_status(client, "can't be advertised: client", advertise)
        # Each is answered, and a client that takes no answers is disconnected: so not all at once.
        service = client.services["/switch"]["id"]
        for call in range(300):
            head = struct.pack("<III", service if call % 2 else 2**31, call, 3)
            client.socket.send(b"\x02" + head + b"cdr" + bytes(call % 5))
            client.text("serviceCallFailure", callId=call)
        uris = ("package://[::1", "file:///\x00", "x" * 10_000, "http://127.0.0.1/a.stl", "package://")
        for number in range(300):
            client.send(op="fetchAsset", uri=uris[number % 5], requestId=number)
            client.wait_for(lambda number=number: number in client.assets, "the refused file")
        assert {status for status, _, _ in client.assets.values()} == {1}


def test_one_client_leaves_topics_for_another(served: Served) -> None:
    one, other = Client(served.port), Client(served.port)
    with closing(one.socket), closing(other.socket):
        for number in range(client_topics.MAX_TOPICS + 10):
            one.advertise(number, f"/many/topic_{number}", "std_msgs/msg/String")
        more = count(client_topics.MAX_TOPICS + 10)
        wait_for_status(
            one,
            "can't be advertised: client",
            lambda: one.advertise(next(more), "/many/topic", "std_msgs/msg/String"),
        )
        other.advertise(1, "/said", "std_msgs/msg/String")
        wait_until(lambda: served.node.count_publishers("/said") == 1)


def test_floods_of_requests_that_are_taken_back(served: Served) -> None:
    client = Client(served.port)

    def flood(ask: Callable[[], None]) -> None:
        for number in range(500):
            ask()
            with suppress(TimeoutError):  # one that takes nothing is disconnected
                while number % 20 == 0:
                    client.take(client.socket.recv(timeout=0.0))

    with closing(client.socket):
        client.wait_for(lambda: "/chatter" in client.channels)
        # The server tells of the end of each topic that others advertised.
        client.wait_for(lambda: not any(name.startswith("/many") for name in client.channels))
        subscription = {"id": 5, "channelId": client.channels["/chatter"]["id"]}

        def subscribe() -> None:
            client.send(op="subscribe", subscriptions=[subscription])
            client.send(op="unsubscribe", subscriptionIds=[5])

        def advertise() -> None:
            client.advertise(1, "/said", "std_msgs/msg/String")
            client.send(op="unadvertise", channelIds=[1])

        for _ in range(20):
            flood(subscribe)
        wait_for_status(client, "sends more than can be done", lambda: flood(advertise))


def test_long_texts_are_cut_in_what_is_said_of_them(served: Served) -> None:
    line_count = len(served.program.lines)
    client = Client(served.port)
    numbers = count(1)
    long = "x" * 1_000_000
    with closing(client.socket):
        for name, kind in ((f"/{long}", "std_msgs/msg/String"), ("/said", f"std_msgs/msg/{long}")):
            client.texts.clear()
            wait_for_status(
                client,
                "has more than 1000 characters",
                lambda name=name, kind=kind: client.advertise(next(numbers), name, kind),
            )
        for name, text in (
            (f"/nobody.{long}", "no node has the parameter /nobody.xxx"),
            ("/nobody.a\nb", "/nobody.a b"),
        ):
            wrong = [{"name": name, "value": 1}]
            wait_for_status(
                client, text, lambda wrong=wrong: client.send(op="setParameters", parameters=wrong)
            )
        wait_for_status(
            client,
            "there is no package 'xxx",
            lambda: client.send(op="fetchAsset", uri=f"package://{long}/a.stl", requestId=next(numbers)),
        )
        assert max(len(said["message"]) for said in client.texts if said["op"] == "status") < 1000
    assert max(map(len, served.program.lines[line_count:])) < 1000


def test_parameters_of_one_request_have_a_limit(served: Served) -> None:
    client = Client(served.port)
    wrong = [{"name": "/nobody.x", "value": 1}] * (parameters.MAX_SET + 7)
    names = ["/other.count"] * (parameters.MAX_PARAMETERS + 1)
    requests: list[tuple[str, dict[str, Any]]] = [
        ("7 of 1007 parameters are not set", {"op": "setParameters", "parameters": wrong}),
        ("asks for 10001 parameters at once", {"op": "getParameters", "parameterNames": names}),
    ]
    with closing(client.socket):
        for text, request in requests:

            def is_said(text: str = text, request: dict[str, Any] = request) -> bool:
                """Return whether the bridge says so, which says only some of all that is wrong in a second."""
                client.texts.clear()
                client.send(**request, id="many")
                client.text("parameterValues", id="many")
                return text in client.statuses()

            wait_until(is_said)


def test_connections_that_say_nothing(served: Served) -> None:
    """Clients that connect and never ask leave room for others."""
    silent = [RawClient(served.port, is_silent=True) for _ in range(200)]
    client = Client(served.port)
    with closing(client.socket):
        client.wait_for(lambda: client.info)
    for one in silent:
        one.socket.close()
