"""foxglove_bridge on graphs that are large, change, or have what it doesn't know."""

from __future__ import annotations

import json
import random
import shutil
import signal
import socket
import ssl
import subprocess
from collections.abc import Callable
from contextlib import ExitStack, closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.conftest import Program
from tests.foxglove.clients import (
    Client,
    bridging,
    connected,
    expect_refusal,
    port_of,
    spun_node,
)
from tests.viewer.conftest import OWN_TYPES
from websockets.exceptions import InvalidMessage, InvalidStatus
from websockets.sync.client import connect

from tfloom.foxglove import bridge, program
from tfloom.foxglove.complaints import MAX_IN_PERIOD, PERIOD_S, Complaints
from tfloom.foxglove.settings import CAPABILITIES, Settings, SettingsError
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.std_msgs.msg import String, UInt8MultiArray
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.rmw.backends import open_participant
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.qos import QoS
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import get_message_class, get_service_class

pytestmark = pytest.mark.wire
StartBridge = Callable[..., tuple[Program, int]]
TOPICS = 100


def test_many_topics(domain_id: int, node: Node) -> None:
    """They are found while a client is connected, each is read, and closed when it is gone."""
    with connected(domain_id) as client:
        names = [f"/many/topic_{number}" for number in range(TOPICS)]
        publishers = {name: node.create_publisher(String, name, 1) for name in names}
        for number, name in enumerate(names):
            client.subscribe(name, number)
        client.wait_for(
            lambda: all(one.get_subscription_count() == 1 for one in publishers.values()), "the subscription"
        )
        heard: dict[int, str] = {}

        def are_all_heard() -> bool:
            heard.update((number, cdr.decode(String, data).data) for number, data in client.messages)
            client.messages.clear()
            for number, name in enumerate(names):
                if (
                    number not in heard
                ):  # the bridge may know of a publisher later than the publisher of the bridge
                    publishers[name].publish(String(data=name))
            return len(heard) == TOPICS

        client.wait_for(are_all_heard, "the messages of all topics")
        assert heard == dict(enumerate(names))
        for name in names[1:]:
            node.destroy_publisher(publishers[name])
        client.wait_for(lambda: len(client.channels.keys() & set(names)) == 1, "the end of the topics")
        assert names[0] in client.channels


def test_client_stays_connected_while_many_topics_come_and_go(domain_id: int, node: Node) -> None:
    """Each topic is a message to each client, and of too many at once, the server would disconnect them."""
    node.create_publisher(String, "/lasting", 1)
    with connected(domain_id, "message_backlog_size:=128") as client:
        with spun_node(domain_id, "many") as many:
            for number in range(TOPICS * 4):
                many.create_publisher(String, f"/many/topic_{number}", 1)
            client.wait_for(lambda: len(client.channels) > TOPICS * 4, "the topics")
        client.wait_for(lambda: len(client.channels) < TOPICS, "the end of the topics")
        assert "/lasting" in client.channels


def test_topic_of_an_unknown_type_is_said_once(
    domain_id: int, node: Node, capfd: pytest.CaptureFixture[str]
) -> None:
    wire = open_participant(domain_id)
    for number in range(3):
        topic = Topic(f"/unknown_{number}", "secret_msgs/msg/Plan", "")
        wire.create_writer(NodeName("/", "planner"), topic, QoS())
    known = node.create_publisher(String, "/known", 1)
    with connected(domain_id) as client:
        client.subscribe("/known", 1)
        client.wait_for(lambda: known.get_subscription_count() == 1, "the subscription")
        known.publish(String(data="x"))
        client.wait_for(lambda: client.messages, "the message of the known type")
        later = node.create_publisher(String, "/later", 1)
        client.wait_for(lambda: "/later" in client.channels)
        node.destroy_publisher(later)
        assert not any(name.startswith("/unknown") for name in client.channels)
    said = capfd.readouterr().err
    assert said.count("the type secret_msgs/msg/Plan has no definition here") == 1
    wire.close()


def test_types_that_another_process_alone_has(domain_id: int, start_program: Callable[..., Program]) -> None:
    with connected(domain_id) as client:
        start_program("python", OWN_TYPES).wait_for("ready")
        client.subscribe("/samples", 1)
        client.wait_for(lambda: client.messages, "a message")
        schema = client.channels["/samples"]["schema"]
        assert schema.startswith("std_msgs/Header header\nlab_msgs/Part[<=2] parts\nfloat64[3] at\n")
        assert "MSG: lab_msgs/Part\n" in schema
        sample: Any = cdr.decode(get_message_class("lab_msgs/msg/Sample"), client.messages[0][1])
        assert list(sample.at) == [1.0, 2.0, 3.0]
        client.wait_for(lambda: "/weigh" in client.services, "the service")
        weigh: Any = get_service_class("lab_msgs/srv/Weigh")
        part: Any = get_message_class("lab_msgs/msg/Part")
        client.call("/weigh", 7, cdr.encode(weigh.Request(part=part(count=4))))
        client.wait_for(lambda: client.responses, "the response")
        assert cdr.decode(weigh.Response, client.responses[7][1]).grams == 10.0


VANISHING = """
from rclpy.node import Node
import rclpy
from std_srvs.srv import SetBool

def hold(_, response):
    print("called", flush=True)
    time.sleep(600)
    return response

rclpy.init()
node = Node("vanishing")
node.create_service(SetBool, "/vanishing", hold)
rclpy.spin(node)
"""


@pytest.mark.usefixtures("short_lease")
def test_service_whose_process_is_killed_during_a_call(
    domain_id: int,
    node: Node,
    start_program: Callable[..., Program],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The call fails with a reason, other calls go on, and the service is there again when it comes back."""
    monkeypatch.setattr("tfloom.foxglove.services.TIMEOUT_S", 1.0)
    node.create_service(SetBool, "/lasting", lambda _, response: response)
    with connected(domain_id) as client:
        program = start_program("python", "-c", VANISHING)
        client.call("/vanishing", 1, cdr.encode(SetBool.Request()))
        program.wait_for("called")
        program.end()
        client.call("/lasting", 2, cdr.encode(SetBool.Request()))
        client.wait_for(lambda: 2 in client.responses, "the other service's response")
        assert "no response from /vanishing" in client.text("serviceCallFailure", callId=1)["message"]
        client.wait_for(lambda: "/vanishing" not in client.services, "the end of the service")
        with spun_node(domain_id, "vanishing") as vanishing:
            vanishing.create_service(SetBool, "/vanishing", lambda _, response: response)
            client.call("/vanishing", 3, cdr.encode(SetBool.Request()))
            client.wait_for(lambda: 3 in client.responses, "the response of the service that came back")


def test_clients_get_the_time_of_the_clock(domain_id: int, node: Node) -> None:
    publisher = node.create_publisher(Clock, "/clock", 1)
    with connected(domain_id, "use_sim_time:=true") as client:
        assert "time" in client.info["capabilities"]

        def has_come() -> bool:
            publisher.publish(Clock(clock=Time(sec=1234, nanosec=5)))
            publisher.publish(Clock(clock=Time(sec=-1)))
            return 1_234_000_000_005 in client.times

        client.wait_for(has_come, "the time")
        assert set(client.times) <= {0, 1_234_000_000_005}
    with connected(domain_id, "capabilities:=[time]") as client:
        assert client.info["capabilities"] == ["time"]
    with connected(domain_id) as client:
        assert "time" not in client.info["capabilities"]


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Return the files of a certificate of 127.0.0.1, and of its key."""
    openssl = shutil.which("openssl")
    if openssl is None:
        pytest.skip("makes a certificate with openssl")
    folder = tmp_path_factory.mktemp("certificate")
    certificate, key = folder / "cert.pem", folder / "key.pem"
    words = (
        *(
            "req",
            "-x509",
            "-newkey",
            "ec",
            "-pkeyopt",
            "ec_paramgen_curve:prime256v1",
            "-nodes",
            "-days",
            "2",
        ),
        *("-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1"),
    )
    command = [openssl, *words, "-keyout", key, "-out", certificate]
    subprocess.run(command, check=True, capture_output=True, timeout=60)
    return certificate, key


def test_encrypted_connections(certificate: tuple[Path, Path], node: Node, start_bridge: StartBridge) -> None:
    """What comes from other sites is refused there, too, and large messages pass whole."""
    publisher = node.create_publisher(UInt8MultiArray, "/big", 1)
    files = f"certfile:={certificate[0]}", f"keyfile:={certificate[1]}"
    program, port = start_bridge("tls:=true", *files)
    assert "Server listening at wss://127.0.0.1:" in program.output
    trust = ssl.create_default_context(cafile=str(certificate[0]))
    with ExitStack() as stack:
        for _ in range(200):  # which begin no TLS
            stack.enter_context(socket.create_connection(("127.0.0.1", port), timeout=30.0))
        with pytest.raises(InvalidStatus, match="403"):
            connect(f"wss://127.0.0.1:{port}", ssl=trust, origin="https://evil.example", proxy=None)  # type: ignore[arg-type]
        client = Client(port, trust)
        stack.enter_context(closing(client.socket))
        client.subscribe("/big", 1)
        client.wait_for(lambda: publisher.get_subscription_count() == 1, "the subscription")
        data = cdr.encode(UInt8MultiArray(data=random.Random(1).randbytes(5_000_000)))
        publisher.publish(data)
        client.wait_for(lambda: client.messages, "the message")
        assert client.messages == [(1, data)]
        with pytest.raises(InvalidMessage):  # plain text
            Client(port)
        program.signal(signal.SIGINT)
        assert program.wait() == 0
    assert "Traceback" not in program.output


def test_certificates_that_are_none_are_one_sentence(
    certificate: tuple[Path, Path], domain_id: int, tmp_path: Path
) -> None:
    wrong = tmp_path / "wrong.pem"
    wrong.write_text("no certificate")
    for first, second in ((wrong, certificate[1]), (certificate[0], wrong), (certificate[1], certificate[0])):
        parameters = ("tls:=true", f"certfile:={first}", f"keyfile:={second}")
        expect_refusal(domain_id, SettingsError, "parameters certfile and keyfile: ", *parameters)
    text = f"parameter certfile: {tmp_path / 'none'}: No such file"
    expect_refusal(domain_id, SettingsError, text, "tls:=true", f"certfile:={tmp_path / 'none'}")


def test_names_match_as_those_of_foxglove_bridge(domain_id: int, node: Node) -> None:
    """Capitals don't matter, the whole name has to match, and the names of later versions are understood."""
    for name in ("/Camera", "/camera2", "/lidar"):
        node.create_publisher(String, name, 1)
    for parameter in ("topic_whitelist", "topic_allowlist"):
        with connected(domain_id, f"{parameter}:=['/cAMERA']") as client:
            client.wait_for(lambda client=client: client.channels)
            assert list(client.channels) == ["/Camera"]
    text = r"parameter topic_whitelist: '\(' is no"
    expect_refusal(domain_id, SettingsError, text, "topic_allowlist:=['(']")


def test_defaults_of_the_documentation(node: Node) -> None:
    settings = Settings(node)
    assert (settings.port, settings.address, settings.tls) == (8765, "127.0.0.1", None)
    assert settings.origins == {"https://app.foxglove.dev", "file://"}
    assert all("/any/name" in names for names in (settings.topics, settings.services, settings.client_topics))
    assert "/node.name" in settings.parameters
    assert "/any/name" not in settings.best_effort_topics
    assert (settings.min_depth, settings.max_depth, settings.backlog) == (1, 25, 128)
    assert (settings.sysinfo_topic, settings.sysinfo_s) == ("", 0.5)
    assert (settings.include_hidden, settings.skips_silent_nodes) == (False, True)
    assert settings.capabilities == {*CAPABILITIES}


@pytest.mark.parametrize(
    ("name", "least", "most"),
    [
        ("port", 0, 65535),
        ("min_qos_depth", 1, 25),
        ("max_qos_depth", 1, 10_000),
        ("message_backlog_size", 1, 100_000),
        ("sysinfo_refresh_interval", 200, 3_600_000),
    ],
)
def test_limits_of_numbers(name: str, least: int, most: int, domain_id: int) -> None:
    def settings(value: int) -> Settings:
        context = Context()
        context.init(args=["--ros-args", "-p", f"{name}:={value}"], domain_id=domain_id)
        node = Node("limits", context=context)
        try:
            return Settings(node)
        finally:
            node.destroy_node()
            context.destroy()

    for value in (least, most):
        settings(value)
    for value in (least - 1, most + 1):
        with pytest.raises(SettingsError, match=f"^parameter {name if value != 26 else 'max_qos_depth'}: "):
            settings(value)
    if name == "sysinfo_refresh_interval":
        assert [settings(value).sysinfo_s for value in (200, 3_600_000)] == [0.2, 3600.0]


@pytest.mark.parametrize(("address", "is_told"), [("127.0.0.1", False), ("::1", False), ("0.0.0.0", True)])
def test_address_that_others_reach_is_told(
    address: str, is_told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    logger = SimpleNamespace(info=lambda _: None, warning=told.append)
    made = SimpleNamespace(
        settings=SimpleNamespace(address=address, tls=None),
        port=1,
        get_logger=lambda: logger,
        close=lambda: None,
    )
    monkeypatch.setattr(bridge, "FoxgloveBridge", lambda: made)
    monkeypatch.setattr(program, "spin", lambda _: None)
    assert program._serve() == 0
    assert told == [program.OPEN_TO_ALL] * is_told


def test_parameters_without_effect_are_said(domain_id: int, capfd: pytest.CaptureFixture[str]) -> None:
    with bridging(domain_id, "num_threads:=0", "use_compression:=true", "publish_client_count:=true"):
        pass
    said = capfd.readouterr().err
    assert said.count("has no effect here") == 2
    assert "The parameter use_compression has no effect here" in said


def test_system_is_served_if_that_is_wanted(domain_id: int) -> None:
    parameters = ("sysinfo:=true", "sysinfo_topic:=/load", "sysinfo_refresh_interval:=200")
    with connected(domain_id, *parameters) as client:
        client.subscribe("/load", 1)
        client.wait_for(lambda: client.messages, "a message")
        assert client.channels["/load"]["encoding"] == "json"
        assert json.loads(client.messages[0][1])["process_memory"] > 1_000_000
    text = "parameter sysinfo_refresh_interval: 10 is not from 200"
    expect_refusal(domain_id, SettingsError, text, "sysinfo_refresh_interval:=10")
    with connected(domain_id) as client:
        client.wait_for(lambda: "/rosout" in client.channels)
        assert "/foxglove_bridge/sysinfo" not in client.channels


@pytest.mark.parametrize(
    ("capabilities", "has_client"),
    [
        ("[parametersSubscribe]", False),
        ("[parameters]", False),
        ("[parameters, parametersSubscribe]", True),
        ("[connectionGraph]", True),
    ],
)
def test_bridge_is_connected_to_itself_only_where_that_does_something(
    domain_id: int, capabilities: str, has_client: bool
) -> None:
    with bridging(domain_id, f"capabilities:={capabilities}") as bridge:
        assert (bridge.own_client is not None) is has_client


def test_launch_file(node: Node, start_program: Callable[..., Program]) -> None:
    """With its parameters; topics that come later are shown although no /clock moves the simulated time."""
    program = start_program(
        *("ros2", "launch", "foxglove_bridge", "foxglove_bridge_launch.xml", "port:=0"),
        *("topic_whitelist:=['/shown']", "use_sim_time:=true", "allowed_origins:=['https://viewer.example']"),
    )
    port = port_of(program)
    client = Client(port)
    with closing(client.socket):
        node.create_publisher(String, "/other_topic", 1)
        node.create_publisher(String, "/shown", 1)
        client.wait_for(lambda: client.channels)
        assert list(client.channels) == ["/shown"]
        assert "time" in client.info["capabilities"]
        client.send(op="getParameters", parameterNames=["/foxglove_bridge.asset_uri_allowlist"], id="one")
        (allowed,) = client.text("parameterValues", id="one")["parameters"]
        assert allowed["value"][0].startswith(r"^package://(?:[-\w%]+/)*[-\w%.]+\.(?:dae|")
        client.send(op="getParameters", parameterNames=["/foxglove_bridge.allowed_origins"], id="two")
        assert client.text("parameterValues", id="two")["parameters"][0]["value"] == [
            "https://viewer.example"
        ]
    program.signal(signal.SIGINT)
    assert program.wait() == 0


def test_many_complaints_are_a_number() -> None:
    logged: list[str] = []
    now_s = [10.0]

    class Logger:
        def warning(self, text: str) -> None:
            logged.append(text)

    complaints = Complaints(Logger(), lambda: now_s[0])  # type: ignore[arg-type]
    for number in range(MAX_IN_PERIOD + 5):
        complaints.say(str(number), None)
    assert logged == [str(number) for number in range(MAX_IN_PERIOD)]
    now_s[0] += PERIOD_S
    complaints.say("next", None)
    complaints.say("one too many", None)
    now_s[0] += PERIOD_S
    complaints.say("last", None)
    assert logged[MAX_IN_PERIOD:] == [
        *("5 more requests of clients could not be done", "next"),
        *("1 more requests of clients could not be done", "last"),
    ]
    now_s[0] += PERIOD_S
    logged.clear()
    for number in range(MAX_IN_PERIOD):
        complaints.say(str(number), None)
    assert len(logged) == MAX_IN_PERIOD
