"""foxglove_bridge, to a client that speaks the subprotocol `foxglove.sdk.v1`."""

from __future__ import annotations

import argparse
import base64
import errno
import os
import signal
import socket
import sys
import threading
from collections.abc import Callable
from contextlib import ExitStack, closing, suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import Program, run_to_end, wait_until
from tests.foxglove.clients import (
    SUBPROTOCOL,
    TIMEOUT_S,
    Client,
    bridging,
    connect_to,
    connected,
    expect_refusal,
)
from tests.viewer.conftest import running_node

from tfloom.foxglove import channels, commands
from tfloom.foxglove.assets import AssetError, read_asset
from tfloom.foxglove.bridge import MAX_ASKING, BridgeError
from tfloom.foxglove.calls import Call, Calls
from tfloom.foxglove.commands import Commands
from tfloom.foxglove.settings import Settings, SettingsError
from tfloom.foxglove.shares import Shares
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.interfaces.visualization_msgs.msg import MarkerArray
from tfloom.node.context.context import Context
from tfloom.node.executing.task import Future
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.exceptions import InvalidHandle
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.qos import DurabilityPolicy, ReliabilityPolicy
from tfloom.rosidl import cdr

pytestmark = pytest.mark.wire
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


StartBridge = Callable[..., tuple[Program, int]]


def test_topics_have_their_definitions_and_exactly_the_published_bytes(domain_id: int, node: Node) -> None:
    publisher = node.create_publisher(MarkerArray, "/markers", 10)
    with connected(domain_id) as client:
        assert client.socket.subprotocol == SUBPROTOCOL
        assert client.info["supportedEncodings"] == ["cdr"]
        assert set(client.info["capabilities"]) == {
            *("clientPublish", "parameters", "parametersSubscribe", "services", "connectionGraph", "assets")
        }
        client.subscribe("/markers", 5)
        channel = client.channels["/markers"]
        assert (channel["encoding"], channel["schemaName"]) == ("cdr", "visualization_msgs/msg/MarkerArray")
        assert channel["schemaEncoding"] == "ros2msg"
        assert channel["schema"].startswith("Marker[] markers\n")
        assert "\nMSG: visualization_msgs/Marker\n" in channel["schema"]
        assert "\nMSG: builtin_interfaces/Time\n" in channel["schema"]
        wait_until(lambda: publisher.get_subscription_count() == 1)
        data = cdr.encode(MarkerArray())
        publisher.publish(data)
        client.wait_for(lambda: client.messages, "the message")
        assert client.messages == [(5, data)]
        client.send(op="unsubscribe", subscriptionIds=[5])
        wait_until(lambda: publisher.get_subscription_count() == 0)
        node.destroy_publisher(publisher)
        client.wait_for(lambda: "/markers" not in client.channels, "the end of the topic")


def test_each_client_gets_kept_messages_and_a_lost_one_is_forgotten(domain_id: int, node: Node) -> None:
    publisher = node.create_publisher(String, "/map_name", LATCHED)
    publisher.publish(String(data="kept"))
    with bridging(domain_id) as bridge:
        for _ in range(2):
            client = connect_to(bridge)
            client.subscribe("/map_name", 1)
            client.wait_for(lambda client=client: client.messages, "the kept message")
            assert cdr.decode(String, client.messages[0][1]).data == "kept"
            client.socket.close()
        wait_until(lambda: publisher.get_subscription_count() == 0)


@pytest.mark.parametrize(("publishers", "each", "backlog"), [(200, 1, 128), (1, 100, 128), (1, 100, 8)])
def test_all_kept_messages_come_whatever_their_number(
    publishers: int, each: int, backlog: int, domain_id: int, node: Node
) -> None:
    qos = QoSProfile(depth=each, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    texts = [str(number) for number in range(publishers * each)]
    for first in range(0, len(texts), each):
        publisher = node.create_publisher(String, "/tf_static", qos)
        for text in texts[first : first + each]:
            publisher.publish(String(data=text))
    with connected(domain_id, f"message_backlog_size:={backlog}") as client:
        client.subscribe("/tf_static", 1)
        client.wait_for(lambda: len(client.messages) >= len(texts), "the kept messages")
        assert sorted(int(cdr.decode(String, data).data) for _, data in client.messages) == [*map(int, texts)]


def test_client_that_leaves_while_kept_messages_wait_leaves_none_to_the_next(
    domain_id: int, node: Node
) -> None:
    qos = QoSProfile(depth=50, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(String, "/tf_static", qos)
    texts = [str(number) for number in range(50)]
    for text in texts:
        publisher.publish(String(data=text))
    with bridging(domain_id, "message_backlog_size:=8") as bridge:
        for count in (3, len(texts)):
            client = connect_to(bridge)
            client.subscribe("/tf_static", 1)
            client.wait_for(lambda client=client, count=count: len(client.messages) >= count, "kept messages")
            client.socket.close()
            got = [cdr.decode(String, data).data for _, data in client.messages]
            assert got == texts[: len(got)]
            wait_until(lambda: publisher.get_subscription_count() == 0)


def test_kept_messages_that_wait_are_as_many_as_the_subscription_may_have(local_context: Context) -> None:
    """A client that reads nothing costs no more."""
    node = Node("bridge", context=local_context)
    node.create_publisher(String, "/kept", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    sent: list[bytes] = []
    sdk: Any = SimpleNamespace(
        id=lambda: 1, topic=lambda: "/kept", log=lambda data, log_time: sent.append(data), close=lambda: None
    )
    channel = channels._TopicChannel(node, sdk, String, Settings(node))
    channel.subscribe(1)
    # More than go out in the meantime, at a quarter of a backlog of 128 each 50 ms.
    for number in range(3 * channels.KEPT_DEPTH):
        channel._log(b"%d" % number)
    assert len(channel._waiting) == channels.KEPT_DEPTH
    assert channel._waiting[-1][1] == b"%d" % (3 * channels.KEPT_DEPTH - 1)
    channel.close()
    node.destroy_node()


def test_best_effort_publisher_that_comes_later_is_heard(domain_id: int, node: Node) -> None:
    reliable = node.create_publisher(String, "/mixed", 1)
    with connected(domain_id) as client:
        client.subscribe("/mixed", 1)
        client.wait_for(lambda: reliable.get_subscription_count() == 1, "the subscription")
        late = node.create_publisher(
            String, "/mixed", QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        )
        wait_until(lambda: late.get_subscription_count() == 1)
        late.publish(String(data="late"))
        client.wait_for(lambda: client.messages, "the late publisher's message")


def test_client_publishes(domain_id: int, node: Node) -> None:
    heard: list[bytes] = []
    subscription = node.create_subscription(String, "/said", heard.append, 10, raw=True)
    with connected(domain_id, "client_topic_whitelist:=['/sai.', '/x y', '/other']") as client:
        client.advertise(3, "/said", "std_msgs/msg/String")
        wait_until(lambda: subscription.get_publisher_count() == 1)
        data = cdr.encode(String(data="by a client"))
        client.publish(3, data)
        client.wait_for(lambda: heard, "the message at the node")
        assert bytes(heard[0]) == data
        # What can't be published is refused with a reason, and the rest still works.
        client.publish(3, data[:9])
        client.wait_for(lambda: "a message to /said can't be decoded" in client.statuses())
        client.advertise(4, "/not_allowed", "std_msgs/msg/String")
        client.wait_for(lambda: "clients may not publish to /not_allowed" in client.statuses())
        client.advertise(5, "/said", "std_msgs/msg/Nothing")
        client.wait_for(lambda: "/said can't be advertised" in client.statuses())
        client.advertise(6, "/other", "std_msgs/msg/String", "json")
        client.wait_for(lambda: "have to be cdr, not json" in client.statuses())
        client.advertise(7, "/x y", "std_msgs/msg/String")
        client.wait_for(lambda: "/x y can't be advertised" in client.statuses())
        client.publish(3, data)
        client.wait_for(lambda: len(heard) == 2, "the second message")
        client.socket.close()
        wait_until(lambda: subscription.get_publisher_count() == 0)


def test_topic_that_was_refused_is_not_waited_for_and_its_channel_is_free(domain_id: int, node: Node) -> None:
    heard: list[str] = []
    node.create_subscription(String, "/said", lambda message: heard.append(message.data), 10)
    with connected(domain_id) as client:
        topics = client.bridge.client_topics
        client.advertise(3, "/said", "nowhere/msg/Type")
        client.wait_for(lambda: "/said can't be advertised" in client.statuses())
        assert topics._noted == topics._shares._taken == {}
        client.publish(3, b"x")
        client.send(op="unadvertise", channelIds=[3])
        client.advertise(3, "/said", "std_msgs/msg/String")
        wait_until(lambda: node.count_publishers("/said") == 1)
        data = cdr.encode(String(data="a text"))
        wait_until(lambda: client.publish(3, data) or heard)
        client.send(op="unadvertise", channelIds=[3])
        wait_until(lambda: node.count_publishers("/said") == 0)
        assert topics._noted == topics._shares._taken == topics._publishers == {}
    assert set(heard) == {"a text"}


def test_patterns_are_of_the_names_that_other_nodes_see(domain_id: int, node: Node) -> None:
    parameter = "client_topic_whitelist:=['(?!/cmd_vel|/foxglove_bridge/).*']"
    with connected(domain_id, parameter) as client:
        for channel, topic in enumerate(("cmd_vel", "/cmd_vel", "~/x", "{node}/x", "/cmd_vel/", "//cmd_vel")):
            client.advertise(channel, topic, "std_msgs/msg/String")
        client.advertise(9, "said", "std_msgs/msg/String")
        wait_until(lambda: node.count_publishers("/said") == 1)
        topics = {topic for topic, _ in node.get_topic_names_and_types()}
        assert topics.isdisjoint({"/cmd_vel", "/foxglove_bridge/x"})
        client.wait_for(lambda: "clients may not publish to /cmd_vel" in client.statuses())


def test_client_calls_services(domain_id: int, node: Node) -> None:
    def switch(request: Any, response: Any) -> Any:
        response.success, response.message = request.data, "switched"
        return response

    service = node.create_service(SetBool, "/switch", switch)
    with connected(domain_id) as client:
        client.call("/switch", 8, cdr.encode(SetBool.Request(data=True)))
        assert client.services["/switch"]["type"] == "std_srvs/srv/SetBool"
        assert client.services["/switch"]["request"]["schema"].strip() == "bool data"
        client.wait_for(lambda: client.responses, "the response")
        encoding, data = client.responses[8]
        assert encoding == "cdr"
        assert cdr.decode(SetBool.Response, data) == SetBool.Response(success=True, message="switched")
        client.call("/switch", 9, b"\x00\x01")
        assert "switched" not in client.text("serviceCallFailure", callId=9)["message"]
        node.destroy_service(service)
        client.wait_for(lambda: "/switch" not in client.services, "the end of the service")


def test_server_that_does_not_respond_is_an_error(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tfloom.foxglove.services.TIMEOUT_S", 0.3)
    go_on = threading.Event()

    def hold(_: Any, response: Any) -> Any:
        go_on.wait(TIMEOUT_S)
        return response

    node.create_service(SetBool, "/slow", hold)
    with connected(domain_id) as client:
        client.call("/slow", 1, cdr.encode(SetBool.Request()))
        failure = client.text("serviceCallFailure", callId=1)
        assert "no response from /slow within 0.3 s" in failure["message"]
        go_on.set()


def test_parameters_are_got_set_and_followed(domain_id: int, node: Node) -> None:
    values = {
        "flag": True,
        "count": 3,
        "gain": 2.0,
        "name": "x",
        "gains": [1.0, 2.5],
        "counts": [1, 2],
        "names": ["a", "b"],
        "a.nested.flag": False,
        "raw": [b"\x01", b"\xff"],
    }
    for name, value in values.items():
        node.declare_parameter(name, value)
    with connected(domain_id, "param_whitelist:=['/other\\..*']") as client:
        wait_until(lambda: "/other/list_parameters" in dict(client.bridge.get_service_names_and_types()))
        client.send(op="getParameters", parameterNames=[], id="all")
        answer = client.text("parameterValues", id="all")["parameters"]
        given = {one["name"].removeprefix("/other."): one for one in answer}
        assert given.keys() >= values.keys()
        assert all(one["name"].startswith("/other.") for one in answer)
        for name, value in values.items():
            if name == "raw":
                assert given[name]["type"] == "byte_array"
                assert base64.b64decode(given[name]["value"]) == b"\x01\xff"
            else:
                assert given[name]["value"] == value
        assert given["gain"]["type"] == "float64"

        changes = [
            {"name": "/other.count", "value": 4},
            {"name": "/other.gain", "value": 5},  # a whole number, of a client in JavaScript
            {"name": "/other.gains", "value": [1, 2]},
            {"name": "/other.names", "value": []},
        ]
        client.send(op="setParameters", parameters=changes, id="set")
        answer = client.text("parameterValues", id="set")["parameters"]
        assert [one["value"] for one in answer] == [4, 5.0, [1.0, 2.0], []]
        assert list(node.get_parameter("names").value) == []
        assert node.get_parameter("gain").value == 5.0
        assert list(node.get_parameter("gains").value) == [1.0, 2.0]

        refused = [
            {"name": "/other.count", "value": "text"},
            {"name": "/nobody.count", "value": 1},
            {"name": "/other.name", "value": {"a": 1}},
        ]
        client.send(op="setParameters", parameters=refused, id="refused")
        client.wait_for(lambda: "/other did not set count" in client.statuses())
        client.wait_for(lambda: "clients may not set /nobody.count" in client.statuses())
        client.wait_for(lambda: "/other.name can't have this value" in client.statuses())
        client.text("parameterValues", id="refused")
        assert node.get_parameter("count").value == 4

        client.send(op="subscribeParameterUpdates", parameterNames=["/other.name"])

        def is_followed() -> bool:
            node.set_parameters([type(node.get_parameter("name"))("name", value="changed")])
            return any(
                {"name": "/other.name", "value": "changed"} in said["parameters"]
                for said in client.texts
                if said["op"] == "parameterValues" and "id" not in said
            )

        client.wait_for(is_followed, "the changed parameter")


def test_silent_node_delays_the_others_only_once(domain_id: int, node: Node) -> None:
    node.declare_parameter("count", 3)
    with running_node(domain_id, "silent"), connected(domain_id) as client:  # nobody spins it
        both = {"/other/list_parameters", "/silent/list_parameters"}
        wait_until(lambda: both <= dict(client.bridge.get_service_names_and_types()).keys())
        client.send(op="getParameters", parameterNames=[], id="all")
        names = {one["name"] for one in client.text("parameterValues", id="all")["parameters"]}
        assert "/other.count" in names, "it did not respond within the time that a node has"
        assert not any(name.startswith("/silent") for name in names)
        assert client.bridge.parameters_of_nodes._silent == {"/silent"}


def test_request_for_parameters_is_turned_down_while_too_many_others_wait(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tfloom.foxglove.bridge.SLOT_S", 0.01)
    node.declare_parameter("count", 3)
    with connected(domain_id) as client:
        slots = client.bridge.parameter_slots
        for _ in range(MAX_ASKING):
            assert slots.acquire(timeout=1.0)
        client.send(op="getParameters", parameterNames=["/other.count"], id="busy")
        assert client.text("parameterValues", id="busy")["parameters"] == []
        client.wait_for(lambda: "asks for parameters while 4 other requests wait" in client.statuses())
        wrong = [{"name": "/other.count", "value": 4}]
        client.send(op="setParameters", parameters=wrong, id="set busy")
        assert client.text("parameterValues", id="set busy")["parameters"] == []
        for _ in range(MAX_ASKING):
            slots.release()

        def is_known() -> bool:
            client.texts.clear()
            client.send(op="getParameters", parameterNames=["/other.count"], id="free")
            return bool(
                client.text("parameterValues", id="free")["parameters"]
                == [{"name": "/other.count", "value": 3}]
            )

        wait_until(is_known)


def test_parameters_that_take_too_long_are_not_set(
    domain_id: int, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    node.declare_parameter("count", 3)
    with connected(domain_id) as client:
        wait_until(lambda: "/other/list_parameters" in dict(client.bridge.get_service_names_and_types()))
        monkeypatch.setattr("tfloom.foxglove.parameters.SET_S", -1.0)
        client.send(op="setParameters", parameters=2 * [{"name": "/other.count", "value": 4}], id="set")
        client.text("parameterValues", id="set")
        assert "2 of 2 parameters are not set: a request may have 1000, and take -1 s" in client.statuses()
    assert node.get_parameter("count").value == 3


def test_messages_pass_while_requests_for_parameters_wait_for_a_silent_node(
    domain_id: int, node: Node, start_bridge: StartBridge
) -> None:
    publisher = node.create_publisher(String, "/chatter", 10)
    program, port = start_bridge()
    if (tasks := Path("/proc", str(program.process.pid), "task")).exists():
        names = [(task / "comm").read_text().strip() for task in tasks.iterdir()]
        assert names.count("tokio-rt-worker") > MAX_ASKING, "all of the SDK's threads may wait for nodes"
    with running_node(domain_id, "silent"), ExitStack() as stack:  # nobody spins it
        clients = [Client(port) for _ in range(MAX_ASKING + 1)]
        for client in clients:
            stack.enter_context(closing(client.socket))
        reader, *askers = clients
        reader.subscribe("/chatter", 1)
        reader.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
        reader.wait_for(lambda: "/silent/list_parameters" in dict(node.get_service_names_and_types()))

        def passes() -> bool:
            """Return whether a message arrived before any of the answers."""
            reader.messages.clear()
            for client in askers:
                client.texts.clear()
                client.send(op="getParameters", parameterNames=["/silent.x"], id="asked")
            publisher.publish(String(data="a message"))
            reader.wait_for(lambda: reader.messages, "the message")
            is_first = not any(map(has_answer, askers))
            for client in askers:
                client.text("parameterValues", id="asked")
            return is_first

        def has_answer(client: Client) -> bool:
            with suppress(TimeoutError):
                client.take(client.socket.recv(timeout=0.0))
            return any(said["op"] == "parameterValues" for said in client.texts)

        assert any(passes() for _ in range(5))


def test_connection_graph(domain_id: int, node: Node) -> None:
    node.create_publisher(String, "/chatter", 1)
    node.create_subscription(String, "/orders", lambda _: None, 1)
    node.create_service(SetBool, "/switch", lambda _, response: response)
    with connected(domain_id) as client:
        client.wait_for(lambda: "/chatter" in client.channels and "/switch" in client.services)
        client.send(op="subscribeConnectionGraph")

        def knows(key: str, name: str, ids: str) -> bool:
            return any(
                one["name"] == name and one[ids] == ["/other"]
                for said in client.texts
                if said["op"] == "connectionGraphUpdate"
                for one in said[key]
            )

        client.wait_for(lambda: knows("publishedTopics", "/chatter", "publisherIds"))
        client.wait_for(lambda: knows("subscribedTopics", "/orders", "subscriberIds"))
        client.wait_for(lambda: knows("advertisedServices", "/switch", "providerIds"))


def test_whitelists_capabilities_and_hidden_names(domain_id: int, node: Node) -> None:
    for name in ("/shown", "/_hidden", "/other_topic"):
        node.create_publisher(String, name, 1)
    parameters = ("topic_whitelist:=['/shown', '/_h.*']", "capabilities:=[connectionGraph]")
    with connected(domain_id, *parameters) as client:
        client.wait_for(lambda: client.channels)
        assert list(client.channels) == ["/shown"]
        assert client.info["capabilities"] == ["connectionGraph"]
        assert client.services == {}
    with connected(domain_id, *parameters, "include_hidden:=true") as client:
        client.wait_for(lambda: set(client.channels) == {"/shown", "/_hidden"})


def test_wrong_parameters_and_a_used_port_are_one_sentence(domain_id: int) -> None:
    wrong = {
        "topic_whitelist:=['(']": r"parameter topic_whitelist: '\(' is not a regular expression: ",
        "capabilities:=[fly]": "parameter capabilities: there is no 'fly', only clientPublish",
        "port:=70000": "parameter port: 70000 is not from 0 to 65535",
        "min_qos_depth:=0": "parameter min_qos_depth: 0 is not from 1",
        "max_qos_depth:=0": "parameter max_qos_depth: 0 is not from 1",
        "tls:=true": "parameter certfile: tls needs a file",
    }
    for parameter, text in wrong.items():
        expect_refusal(domain_id, SettingsError, text, parameter)
    with bridging(domain_id) as bridge:
        assert bridge.server is not None
        port = bridge.port
        expect_refusal(domain_id, BridgeError, rf"can't listen at 127\.0\.0\.1:{port}: ", f"port:={port}")


def test_files_are_read_where_they_are_allowed(
    domain_id: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    share = tmp_path / "arm_description"
    (share / "meshes").mkdir(parents=True)
    (share / "meshes" / "link 1.stl").write_bytes(b"solid")
    (tmp_path / "secret.stl").write_bytes(b"secret")
    (share / "secret.txt").write_bytes(b"secret")
    os.mkfifo(share / "meshes" / "pipe.stl")
    (share / "meshes" / "zero.stl").symlink_to("/dev/zero")
    monkeypatch.setattr(read_asset, "__defaults__", (lambda _: share,))
    with connected(domain_id) as client:
        uris = [
            "package://arm_description/meshes/link%201.stl",
            "package://arm_description/../secret.stl",
            "package://arm_description/%2e%2e/secret.stl",
            "package://arm_description/secret.txt",
            f"file://{tmp_path}/secret.stl",
            "package://arm_description/meshes/none.stl",
            "package://arm_description/meshes/pipe.stl",
            "package://arm_description/meshes/zero.stl",
        ]
        for number, uri in enumerate(uris):
            client.send(op="fetchAsset", uri=uri, requestId=number)
        client.wait_for(lambda: len(client.assets) == len(uris))
        assert client.assets[0] == (0, "", b"solid")
        for number in range(1, len(uris)):
            status, _, data = client.assets[number]
            assert (status, data) == (1, b"")
        with pytest.raises(AssetError, match="leads out of its package"):
            read_asset("package://a/%2e%2e/secret.stl", client.bridge.settings, lambda _: share)


def test_failed_request_is_logged_and_the_next_one_is_done(node: Node) -> None:
    done: list[int] = []

    def fail() -> None:
        raise LookupError("planted")

    said: list[str] = []
    queue = Commands(node, said.append)
    queue.put_end(fail)
    queue.put_end(lambda: done.append(1))
    wait_until(lambda: done)
    assert said == ["A client's request failed: LookupError: planted"]


def queue_of_nobody(said: list[str]) -> Commands:
    """Return a queue that `_run` alone empties."""
    node: Any = argparse.Namespace(create_guard_condition=lambda _: argparse.Namespace(trigger=lambda: None))
    return Commands(node, said.append)


@pytest.mark.parametrize("size", [1, commands.MAX_BYTES // 8])
def test_client_that_sends_too_many_messages_keeps_nobody_from_anything(
    size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(commands, "DROPPED_S", 0.0)
    said: list[str] = []
    done: list[str] = []
    queue = queue_of_nobody(said)
    for _ in range(2):  # what was done has its place back
        done.clear()
        said.clear()
        for client in (1, 2):
            for _ in range(commands.MAX_MESSAGES):
                queue.put_message(client, size, lambda client=client: done.append(f"message of {client}"))
        queue.put_message(3, size, lambda: done.append("message of 3"))
        queue.put_latest("a", lambda: done.append("subscribe"))
        queue._run()
        most = min(commands.MAX_MESSAGES, commands.MAX_BYTES // size)
        assert done.count("message of 1") == most // 2
        assert done.count("message of 2") == most // 4
        assert done[-2:] == ["message of 3", "subscribe"]
        assert said == [
            f"client {client} sends more than can be done: {commands.MAX_MESSAGES - most // share} "
            "of its messages and requests are dropped"
            for client, share in ((1, 2), (2, 4))
        ]
    queue._run()
    assert queue._messages._number._taken == queue._messages._bytes._taken == {}


def test_what_is_dropped_is_told_once_in_a_while(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(commands, "MAX_REQUESTS", 0)
    said: list[str] = []
    queue = queue_of_nobody(said)
    for _ in range(5):
        assert not queue.put_request(1, lambda: pytest.fail("it was dropped"))
        queue._run()
    assert len(said) == 1
    queue._next_dropped_s = 0.0
    queue._run()
    assert "4 of its messages" in said[1]


def test_client_that_changes_its_mind_leaves_only_what_it_asked_for_last() -> None:
    queue = queue_of_nobody([])
    done: list[tuple[str, int]] = []
    for number in range(1000):
        for key in ("a", "b"):
            queue.put_latest(key, lambda key=key, number=number: done.append((key, number)))
    assert queue._waiting.qsize() == 2
    queue._run()
    assert done == [("a", 999), ("b", 999)]
    queue.put_latest("a", lambda: done.append(("a", 1000)))
    queue._run()
    assert done[2:] == [("a", 1000)]


def test_requests_that_wait_have_a_limit_and_their_ends_have_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(commands, "MAX_REQUESTS", 10)
    queue = queue_of_nobody([])
    done: list[int] = []
    taken = [queue.put_request(1, lambda number=number: done.append(number)) for number in range(8)]
    assert taken == [True] * 5 + [False] * 3
    assert queue.put_request(2, lambda: done.append(100))
    for number in range(5):
        queue.put_end(lambda number=number: done.append(-number))
    queue._run()
    assert done == [0, 1, 2, 3, 4, 100, 0, -1, -2, -3, -4]
    assert queue.put_request(1, lambda: None)


def test_no_client_has_more_of_a_limit_than_is_left_for_others() -> None:
    shares = Shares(12)
    assert [shares.take(1) for _ in range(7)] == [True] * 6 + [False]
    assert [shares.take(2) for _ in range(4)] == [True] * 3 + [False]
    assert shares.take(3)
    assert not shares.take(3, 2)
    shares.give_back(1, 6)
    assert shares.take(3, 4)
    assert shares.take(4, 0)
    shares.give_back(2, 3)
    shares.give_back(3, 5)
    assert shares._taken == {}
    assert shares.take(5, 12)


def test_program_serves_until_it_is_stopped(domain_id: int, start_bridge: StartBridge) -> None:
    program, port = start_bridge()
    client = Client(port)
    assert "Server listening at ws://127.0.0.1:" in program.output
    client.wait_for(lambda: client.info)
    client.socket.close()
    program.signal(signal.SIGINT)
    assert program.wait() == 0


class LeavingClient:
    """The client of a service whose server leaves while, or after, it is looked for."""

    def __init__(self, error: Exception, *, is_found: bool = True) -> None:
        self._error = error
        self._is_found = is_found

    def service_is_ready(self) -> bool:
        if not self._is_found:
            raise self._error
        return True

    def call_async(self, _: object) -> None:
        raise self._error


def test_server_that_leaves_during_a_call_ends_no_other_call(monkeypatch: pytest.MonkeyPatch) -> None:
    class Ready:
        service_is_ready = staticmethod(lambda: True)

        def call_async(self, request: str) -> Future[str]:
            future: Future[str] = Future()
            future.set_result(request)
            return future

    clients: dict[str, Any] = {
        "/destroyed": LeavingClient(InvalidHandle("it was destroyed")),
        "/closed": LeavingClient(ClosedError("it is closed")),
        "/gone": LeavingClient(InvalidHandle("it was destroyed"), is_found=False),
        "/there": Ready(),
    }
    node: Any = argparse.Namespace(context=argparse.Namespace(ok=lambda: True))
    calls = Calls(node)
    monkeypatch.setattr(calls, "_client", lambda call: clients[call.name])
    asked = [Call(SetBool, name, name) for name in clients]
    assert calls.call_all(asked, 5.0) == [None, None, None, "/there"]


def test_server_that_leaves_after_it_was_asked_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    class Left:
        service_is_ready = staticmethod(lambda: True)
        remove_pending_request = staticmethod(lambda _: None)

        def call_async(self, _: object) -> Future[str]:
            future: Future[str] = Future()
            future.cancel()
            return future

    node: Any = argparse.Namespace(context=argparse.Namespace(ok=lambda: True))
    calls = Calls(node)
    monkeypatch.setattr(calls, "_client", lambda _: Left())
    found: list[Any] = []
    asked = [Call(SetBool, "/left", "")]
    threading.Thread(target=lambda: found.append(calls.call_all(asked, 3600.0)), daemon=True).start()
    wait_until(lambda: found)
    assert found == [[None]]


def test_program_that_can_not_serve_says_why_in_one_sentence(
    domain_id: int, start_program: Callable[..., Program]
) -> None:
    assert domain_id
    with socket.create_server(("127.0.0.1", 0)) as used:
        port = used.getsockname()[1]
        for parameter, text in (
            (
                f"port:={port}",
                f"foxglove_bridge: can't listen at 127.0.0.1:{port}: {os.strerror(errno.EADDRINUSE)}",
            ),
            ("port:=70000", "foxglove_bridge: parameter port: 70000 is not from 0 to 65535"),
            (
                "allowed_origins:=['*']",
                "foxglove_bridge: parameter allowed_origins: '*' is not a site as browsers",
            ),
        ):
            program = start_program(
                "tfloom", "run", "foxglove_bridge", "foxglove_bridge", "--ros-args", "-p", parameter
            )
            assert program.wait() == 1
            assert program.lines[1:] == ["[ros2run]: Process exited with failure 1"]
            assert program.lines[0].startswith(text)
            assert "while" not in program.lines[0]


def test_missing_extra_is_one_sentence() -> None:
    program = (
        "import sys; sys.modules['foxglove'] = None\n"
        "from tfloom.foxglove import program\n"
        "program.find_spec = lambda _: None\n"
        "raise SystemExit(program.main([]))"
    )
    done = run_to_end([sys.executable, "-c", program])
    sentence = "foxglove_bridge needs foxglove-sdk, which is not installed: pip install 'tfloom[foxglove]'"
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"foxglove_bridge: {sentence}\n"
