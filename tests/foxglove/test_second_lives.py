"""What follows in foxglove_bridge when something has ended, and comes again."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable
from contextlib import closing
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.foxglove.clients import Client, bridging, connect_to, connected

from tfloom.foxglove import services
from tfloom.interfaces.std_msgs.msg import Int64, String
from tfloom.interfaces.std_srvs.srv import SetBool, Trigger
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.rosidl import cdr

pytestmark = pytest.mark.wire


def test_bridge_starts_again_at_its_port_after_close(domain_id: int, node: Node) -> None:
    """Clients were connected at the end, so that the system still remembers connections of this port."""
    node.create_publisher(String, "/chatter", 1)
    port = 0
    for _ in range(3):
        with bridging(domain_id, f"port:={port}") as bridge:
            assert port in {0, bridge.port}
            port = bridge.port
            client = connect_to(bridge)
            client.wait_for(lambda client=client: "/chatter" in client.channels)
            bridge.close()
            wait_until(client.is_closed, what="the end of the bridge")
        bridge.close()  # does nothing more
        with pytest.raises(ConnectionRefusedError):
            Client(port)


LEAVE: dict[str, Callable[[Client], None]] = {
    "by unsubscribing": lambda client: client.send(op="unsubscribe", subscriptionIds=[5]),
    "by a farewell": lambda client: client.socket.close(),
    "without a word": lambda client: client.socket.socket.shutdown(socket.SHUT_RDWR),
}


@pytest.mark.parametrize("way", LEAVE)
def test_client_that_comes_again_is_served_as_before(way: str, domain_id: int, node: Node) -> None:
    publisher = node.create_publisher(String, "/chatter", 1)
    with bridging(domain_id) as bridge:
        client = connect_to(bridge)
        for number in range(3):
            if number and way != "by unsubscribing":
                client = connect_to(bridge)
            client.messages.clear()
            client.subscribe("/chatter", 5)
            client.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
            data = cdr.encode(String(data=f"number {number:04}"))
            messages = client.messages

            def has_come(data: bytes = data, messages: list[Any] = messages) -> bool:
                publisher.publish(data)
                return (5, data) in messages

            client.wait_for(has_come, "the message")
            LEAVE[way](client)
            wait_until(lambda: publisher.get_subscription_count() == 0)
        client.socket.close()


def test_topic_that_comes_again_is_another_channel(domain_id: int, node: Node) -> None:
    with connected(domain_id) as client:
        ids = set()
        for kind, message in (
            (String, String(data="text of 12.")),
            (Int64, Int64(data=7)),
            (String, String()),
        ):
            publisher = node.create_publisher(kind, "/chatter", 1)
            client.messages.clear()
            client.subscribe("/chatter", 5)
            client.wait_for(lambda publisher=publisher: publisher.get_subscription_count() == 1, "a reader")
            assert client.channels["/chatter"]["schemaName"] == kind._TYPE_NAME
            ids.add(client.channels["/chatter"]["id"])
            publisher.publish(message)
            data = cdr.encode(message)
            client.wait_for(lambda data=data: any(data in got for _, got in client.messages), "the message")
            node.destroy_publisher(publisher)
            client.wait_for(lambda: "/chatter" not in client.channels, "the end of the topic")
        assert len(ids) == 3


def test_what_is_advertised_again_is_published(domain_id: int, node: Node) -> None:
    heard: list[str] = []
    said = node.create_subscription(String, "/said", lambda message: heard.append(message.data), 10)
    with connected(domain_id) as client:
        for number in range(3):
            client.advertise(3, "/said", "std_msgs/msg/String")
            wait_until(lambda: said.get_publisher_count() == 1)
            client.publish(3, cdr.encode(String(data=f"number {number:04}")))
            wait_until(lambda number=number: f"number {number:04}" in heard)
            client.send(op="unadvertise", channelIds=[3])
            wait_until(lambda: said.get_publisher_count() == 0)
            client.publish(3, cdr.encode(String(data="too late")))
        assert heard == ["number 0000", "number 0001", "number 0002"]


def test_parameters_are_sent_while_a_client_subscribes_to_them(domain_id: int, node: Node) -> None:
    node.declare_parameter("first", 0)
    node.declare_parameter("second", 0)

    def values(client: Client, name: str) -> list[Any]:
        return [
            parameter["value"]
            for said in client.texts
            if said["op"] == "parameterValues"
            for parameter in said["parameters"]
            if parameter["name"] == f"/other.{name}"
        ]

    def change(name: str, value: int) -> None:
        node.set_parameters([Parameter(name, value=value)])

    with connected(domain_id) as client:
        own = client.bridge.own_client
        wait_until(lambda: own._connection is not None)
        client.send(op="subscribeParameterUpdates", parameterNames=["/other.first", "/other.second"])
        client.wait_for(lambda: change("first", 1) or 1 in values(client, "first"))
        client.send(op="unsubscribeParameterUpdates", parameterNames=["/other.first"])
        client.send(op="getParameters", parameterNames=[], id="all is read")
        client.text("parameterValues", id="all is read")
        client.texts.clear()
        change("first", 2)
        client.wait_for(lambda: change("second", 3) or 3 in values(client, "second"))
        assert values(client, "first") == []
        client.send(op="subscribeParameterUpdates", parameterNames=["/other.first"])
        client.wait_for(lambda: change("first", 4) or 4 in values(client, "first"))


def test_service_that_comes_again_is_called_by_its_new_type(domain_id: int, node: Node) -> None:
    def answer(_: Any, response: Any) -> Any:
        response.success, response.message = True, type(response).__module__
        return response

    requests = {SetBool: SetBool.Request(data=True), Trigger: Trigger.Request()}
    with connected(domain_id) as client:
        for number, kind in enumerate((SetBool, Trigger, SetBool)):
            service = node.create_service(kind, "/switch", answer)
            client.call("/switch", number, cdr.encode(requests[kind]))
            assert client.services["/switch"]["type"] == kind._TYPE_NAME
            client.wait_for(lambda number=number: number in client.responses, "the response")
            assert cdr.decode(kind.Response, client.responses[number][1]).success
            node.destroy_service(service)
            client.wait_for(lambda: "/switch" not in client.services, "the end of the service")


def test_response_that_comes_too_late_is_nobodys(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The client of the service is kept for further calls, and with it what waits for responses."""
    go_on = threading.Event()
    go_on.set()
    asked: list[bool] = []

    def switch(request: Any, response: Any) -> Any:
        asked.append(request.data)
        go_on.wait(30.0)
        response.success, response.message = request.data, f"number {len(asked)}"
        return response

    node.create_service(SetBool, "/switch", switch)
    with connected(domain_id) as client:
        client.call("/switch", 0, cdr.encode(SetBool.Request(data=True)))
        client.wait_for(lambda: client.responses, "the response to the first call")
        ((_, caller),) = client.bridge.calls._clients.items()
        go_on.clear()
        with monkeypatch.context() as patched:
            patched.setattr(services, "TIMEOUT_S", 0.3)
            client.call("/switch", 1, cdr.encode(SetBool.Request(data=True)))
            failure = client.text("serviceCallFailure", callId=1)
        assert "no response from /switch within 0.3 s" in failure["message"]
        assert caller._pending == {}
        wait_until(lambda: asked == [True, True])
        go_on.set()
        client.call("/switch", 2, cdr.encode(SetBool.Request(data=False)))
        client.wait_for(lambda: 2 in client.responses, "the response to the last call")
        assert set(client.responses) == {0, 2}
        response = cdr.decode(SetBool.Response, client.responses[2][1])
        assert (response.success, response.message) == (False, "number 3")
        assert caller._pending == {}


def test_calls_beyond_the_limit_fail_at_once_and_there_is_room_when_others_have_ended(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(services, "MAX_CALLS", 3)  # of which one client may have two
    go_on = threading.Event()
    asked: list[bool] = []

    def switch(request: Any, response: Any) -> Any:
        asked.append(request.data)
        go_on.wait(30.0)
        response.success = True
        return response

    node.create_service(SetBool, "/switch", switch)
    request = cdr.encode(SetBool.Request(data=True))
    with connected(domain_id) as client, closing(connect_to(client.bridge).socket):
        for number in range(3):
            client.call("/switch", number, request)
        failure = next(iter(client.text("serviceCallFailure")["message"].splitlines()))
        assert "calls /switch while as many calls wait for a response as it may have" in failure
        client.wait_for(lambda: "calls /switch while as many calls" in client.statuses(), "the status")
        assert client.responses == {}
        go_on.set()
        client.wait_for(lambda: len(client.responses) == 2, "the responses of the others")
        client.call("/switch", 7, request)
        client.wait_for(lambda: 7 in client.responses, "the next response")


def test_client_of_a_service_that_has_left_is_made_anew(domain_id: int, node: Node) -> None:
    with connected(domain_id) as client:
        calls = client.bridge.calls
        for number in range(2):
            service = node.create_service(Trigger, "/trigger", lambda _, response: response)
            client.call("/trigger", number, cdr.encode(Trigger.Request()))
            client.wait_for(lambda number=number: number in client.responses, "the response")
            assert [name for name, _ in calls._clients] == ["/trigger"]
            node.destroy_service(service)
            client.wait_for(lambda: "/trigger" not in client.services, "the end of the service")
            wait_until(lambda: not calls._clients)


def test_graph_that_does_not_change_is_looked_at_once(domain_id: int, node: Node) -> None:
    with bridging(domain_id) as bridge:
        graph = bridge._wire()[0].graph
        for number in range(2):
            publisher = node.create_publisher(String, "/chatter", 1)
            wait_until(lambda: ("/chatter", String._TYPE_NAME) in bridge.channels._channels)
            wait_until(lambda: bridge._seen_changes == graph.changes(), what=f"a quiet graph, round {number}")
            node.destroy_publisher(publisher)
            wait_until(lambda: ("/chatter", String._TYPE_NAME) not in bridge.channels._channels)
        channels = bridge.channels
    assert (channels._channels, channels._by_id) == ({}, {})
    channels.close()  # does nothing more
    channels.subscribe(1, 1)
    channels.unsubscribe(1, 1)


def test_nothing_is_published_by_the_own_client_after_its_end(domain_id: int) -> None:
    with bridging(domain_id) as bridge, closing(connect_to(bridge).socket):
        own = bridge.own_client
        assert own is not None
        wait_until(lambda: own._is_subscribed)
        own.close()
        assert not own._thread.is_alive()
        assert own._connection is None
        bridge._published_changes = -1
        bridge.publish_connections()
        assert bridge._published_changes == -1
        own.close()
