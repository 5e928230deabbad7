"""foxglove_bridge publishes changes of the graph and of parameters, also while clients subscribe."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, nullcontext
from types import SimpleNamespace
from typing import Any

import pytest
from foxglove import ConnectionGraph, Parameter
from tests.conftest import Program, wait_until
from tests.foxglove.clients import Client, bridging, connected

from tfloom.foxglove import own_client
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.node import Node

ROUNDS = 8
"""Number of times that a client subscribes and unsubscribes."""


def publishes(client: Client, topic: str) -> bool:
    """Return whether the connection graph that a client has got names a publisher of a topic."""
    return any(
        one["name"] == topic
        for said in client.texts
        if said["op"] == "connectionGraphUpdate"
        for one in said["publishedTopics"]
    )


def test_bridge_lives_while_clients_subscribe_and_all_changes(
    node: Node, start_bridge: Callable[..., tuple[Program, int]]
) -> None:
    """A separate program, because a bridge that hangs holds the GIL."""
    node.declare_parameter("count", 0)
    _, port = start_bridge()
    is_done = threading.Event()

    def change() -> None:
        number = 0
        while not is_done.wait(0.005):
            number += 1
            node.set_parameters([type(node.get_parameter("count"))("count", value=number)])

    changing = threading.Thread(target=change)
    changing.start()
    try:
        for number in range(ROUNDS):
            client = Client(port)
            with closing(client.socket):
                publisher = node.create_publisher(String, f"/round_{number}", 1)
                client.send(op="subscribeConnectionGraph")
                client.send(
                    op="subscribeParameterUpdates", parameterNames=["/other.count", f"/other.n{number}"]
                )
                client.text("connectionGraphUpdate")
                client.text("parameterValues")
                client.send(op="unsubscribeParameterUpdates", parameterNames=["/other.count"])
                client.send(op="unsubscribeConnectionGraph")
                node.destroy_publisher(publisher)
    finally:
        is_done.set()
        changing.join()


def test_own_client_is_subscribed_before_it_publishes(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the SDK's functions, it publishes the graph alone: each waits for the SDK's lock with the GIL held."""
    done: list[object] = []

    class Connection:
        def send(self, text: str) -> None:
            done.append(json.loads(text)["op"])

        def __iter__(self) -> Iterator[str]:
            for op in ("serverInfo", "connectionGraphUpdate", "status"):
                done.append(own.publish_connections(ConnectionGraph()))
                yield json.dumps({"op": op})
            own.publish_parameters([Parameter("count", value=1)])

    server: Any = SimpleNamespace(publish_connection_graph=lambda _: done.append("published"))
    inner: Any = SimpleNamespace(host="127.0.0.1", port=1, connect=lambda _: nullcontext())
    own = own_client.OwnClient(server, inner, ["connectionGraph"], None)  # type: ignore[arg-type]
    monkeypatch.setattr(own_client, "connect", lambda *_, **__: nullcontext(Connection()))
    own._serve()
    assert done == ["subscribeConnectionGraph", False, False, "published", True, "setParameters"]


def test_own_client_connects_again(domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own_client, "RETRY_S", 0.05)
    node.declare_parameter("count", 0)
    with connected(domain_id) as client:
        client.send(op="subscribeConnectionGraph")
        client.send(op="subscribeParameterUpdates", parameterNames=["/other.count"])
        own = client.bridge.own_client
        assert own is not None
        wait_until(lambda: own._is_subscribed)
        connection = own._connection
        assert connection is not None
        assert connection.socket.gettimeout() is None, "it ends when nothing comes for a while"
        connection.socket.close()
        wait_until(lambda: own._connection not in {None, connection})
        node.create_publisher(String, "/later", 1)
        client.wait_for(lambda: publishes(client, "/later"), "the later graph")
        node.set_parameters([type(node.get_parameter("count"))("count", value=1)])
        client.wait_for(
            lambda: any(
                {"name": "/other.count", "value": 1} in said["parameters"]
                for said in client.texts
                if said["op"] == "parameterValues"
            ),
            "the later value",
        )


def test_no_connection_is_said_once(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """Clients get all else, and `close` returns."""
    tries = []

    def refuse(*_: object, **__: object) -> None:
        tries.append(1)
        raise ConnectionRefusedError(111, "Connection refused")

    monkeypatch.setattr(own_client, "RETRY_S", 0.01)
    monkeypatch.setattr(own_client, "connect", refuse)
    with connected(domain_id) as client:
        wait_until(lambda: len(tries) > 3)
        client.bridge.publish_connections()
        client.wait_for(lambda: "/rosout" in client.channels)
    assert (
        capfd.readouterr().err.count("Clients get no connection graph and no changed parameters until") == 1
    )


def test_no_thread_is_a_warning(
    domain_id: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def refuse(_: own_client.OwnClient) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(own_client.OwnClient, "start", refuse)
    with connected(domain_id) as client:
        client.bridge.publish_connections()
        client.wait_for(lambda: "/rosout" in client.channels)
    warning = "Clients get no connection graph and no changed parameters: can't start new thread"
    assert warning in capfd.readouterr().err


def test_requests_of_others_are_not_its_own(domain_id: int) -> None:
    with bridging(domain_id) as bridge:
        own = bridge.own_client
        assert own is not None
        assert own.changed_parameters(None) is None
        assert own.changed_parameters("other") is None
        assert own.changed_parameters(own._secret) == []
