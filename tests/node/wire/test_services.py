"""Killed servers, many clients at once, and servers of other vendors."""

from __future__ import annotations

import signal
import subprocess
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest
from tests.conftest import Program, wait_until
from tests.node.wire.conftest import PROGRAMS
from tests.zenoh_ports import NEEDS_ZENOH

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.node.endpoints.client import NoResponseError
from tfloom.node.endpoints.service_introspection import ServiceIntrospectionState
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.rmw.cyclone import services as cyclone_services
from tfloom.rmw.errors import ForeignPeerError

Start = Callable[..., Program]
Finish = Callable[..., Any]


def test_server_killed_during_a_call(
    short_lease: float, node: Node, executor: SingleThreadedExecutor, start: Start, finish: Finish
) -> None:
    server = start("service_server")
    client, hang = node.create_client(AddTwoInts, "add"), node.create_client(AddTwoInts, "hang")
    assert client.wait_for_service(timeout_sec=20)
    assert hang.wait_for_service(timeout_sec=20)
    assert finish(client.call_async(AddTwoInts.Request(a=40, b=2))).sum == 42
    lost = hang.call_async(AddTwoInts.Request())
    outcome: list[object] = []

    def call() -> None:
        outcome.append(hang.call(AddTwoInts.Request(), timeout_sec=1.0))

    waiting = threading.Thread(target=call)
    waiting.start()
    server.wait_for("hanging")
    server.signal(signal.SIGKILL)
    server.wait()
    while waiting.is_alive():
        executor.spin_once(timeout_sec=0.1)
    assert outcome == [None]
    wait_until(lambda: not hang.service_is_ready())
    assert not hang.wait_for_service(timeout_sec=0.0)
    wait_until(lambda: not client.service_is_ready())
    executor.spin_until_future_complete(lost, timeout_sec=20)
    assert isinstance(lost.exception(), NoResponseError)
    assert not hang._pending

    start("service_server")
    assert client.wait_for_service(timeout_sec=20)
    assert finish(client.call_async(AddTwoInts.Request(a=1, b=2))).sum == 3


def test_restarted_server_is_called_at_once(
    node: Node, start: Start, finish: Finish, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The lease of the killed server must last until the next one has started, also on a slow machine.
    monkeypatch.setenv("TFLOOM_LEASE_S", "100")
    client = node.create_client(AddTwoInts, "add")
    server = start("service_server")
    assert client.wait_for_service(timeout_sec=20)
    server.signal(signal.SIGKILL)
    server.wait()
    start("service_server")
    wait_until(lambda: client._endpoint._requests.matched_count() == 2)
    wait_until(lambda: client._endpoint._responses.matched_count() == 2)
    assert finish(client.call_async(AddTwoInts.Request(a=1, b=2))).sum == 3


def test_client_and_server_events_have_the_same_ids(
    node: Node, start: Start, finish: Finish, spin_until: Callable[..., None]
) -> None:
    start("service_server")
    client = node.create_client(AddTwoInts, "add")
    qos = QoSProfile(depth=10)
    client.configure_introspection(node.get_clock(), qos, ServiceIntrospectionState.METADATA)
    events: list[AddTwoInts.Event] = []
    subscription = node.create_subscription(AddTwoInts.Event, "add/_service_event", events.append, qos)
    assert client.wait_for_service(timeout_sec=20)
    spin_until(lambda: subscription.get_publisher_count() == 2)
    for number in range(3):
        assert finish(client.call_async(AddTwoInts.Request(a=number, b=1))).sum == number + 1
    spin_until(lambda: len(events) == 12)
    assert len({bytes(event.info.client_gid) for event in events}) == 1
    for number in range(3):
        told = {event.info.event_type: event for event in events if event.info.sequence_number == number + 1}
        assert set(told) == {
            ServiceEventInfo.REQUEST_SENT,
            ServiceEventInfo.REQUEST_RECEIVED,
            ServiceEventInfo.RESPONSE_SENT,
            ServiceEventInfo.RESPONSE_RECEIVED,
        }
        assert told[ServiceEventInfo.REQUEST_RECEIVED].request[0].a == number
        assert told[ServiceEventInfo.RESPONSE_SENT].response[0].sum == number + 1
        assert not told[ServiceEventInfo.REQUEST_SENT].request  # metadata alone


def test_each_of_many_client_processes_receives_its_responses(
    domain_id: int, start: Start, start_program: Callable[..., Program]
) -> None:
    start("service_server")
    callers = [
        start_program(
            "python",
            PROGRAMS / "service_clients.py",
            *map(str, (number, 4, 5)),
            stdin=subprocess.PIPE,
        )
        for number in range(2)
    ]
    for caller in callers:
        caller.wait_for("ready")
    for caller in callers:
        caller.process.stdin.write("go\n")
        caller.process.stdin.flush()
    for caller in callers:
        assert caller.wait(60) == 0, caller.output
        assert caller.lines[-1] == "right: 20"


def test_client_of_another_vendor_is_ignored_with_one_log_line(
    node: Node,
    executor: SingleThreadedExecutor,
    start: Start,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    asked: list[AddTwoInts.Request] = []

    def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        asked.append(request)
        return response

    node.create_service(AddTwoInts, "add", add)
    monkeypatch.setattr(cyclone_services, "CYCLONE_VENDOR", b"\x01\x0f")  # as if all peers were Fast DDS's
    start("service_caller")
    advice = (
        "dropped a request: a client of /add, /caller, runs on another DDS vendor, whose form of services"
    )
    text = ""

    def is_told() -> bool:
        nonlocal text
        executor.spin_once(timeout_sec=0.1)
        text += capsys.readouterr().err
        return advice in text

    wait_until(is_told)
    for _ in range(5):
        executor.spin_once(timeout_sec=0.1)
    assert (text + capsys.readouterr().err).count(advice) == 1
    assert not asked


def test_server_of_another_vendor_is_not_called_with_one_log_line(
    node: Node,
    start: Start,
    finish: Finish,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    server = start("service_server")
    client = node.create_client(AddTwoInts, "hang")
    assert client.wait_for_service(timeout_sec=20)
    monkeypatch.setattr(cyclone_services, "CYCLONE_VENDOR", b"\x01\x0f")  # as if all peers were Fast DDS's
    assert not client.service_is_ready()
    assert not client.wait_for_service(timeout_sec=0.3)
    advice = (
        "a server of /hang, /server, runs on another DDS vendor, whose form of services isn't ours (topics pass, "
        "services don't): start it with RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"
    )
    assert capsys.readouterr().err.count(advice) == 1
    with pytest.raises(ForeignPeerError, match="runs on another DDS vendor"):
        client.call_async(AddTwoInts.Request())
    assert not client._pending
    monkeypatch.undo()
    assert client.service_is_ready()
    adding = node.create_client(AddTwoInts, "add")
    assert adding.wait_for_service(timeout_sec=20)
    assert finish(adding.call_async(AddTwoInts.Request(a=1, b=1))).sum == 2
    assert "hanging" not in server.output  # no part of the rejected call was sent before


@pytest.mark.parametrize("local_wire", [pytest.param("rmw_zenoh_cpp", marks=NEEDS_ZENOH)], indirect=True)
def test_publisher_ends_at_once_while_clients_hear_that_their_server_has_ended(node: Node) -> None:
    """Zenoh ends a publisher with a heartbeat without releasing the GIL, for which the clients' news must not wait."""
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    clients = [node.create_client(AddTwoInts, "add") for _ in range(20)]
    for _ in range(20):
        service = node.create_service(AddTwoInts, "add", lambda _, response: response)
        publisher = node.create_publisher(AddTwoInts.Event, "kept", kept)
        assert all(client.wait_for_service(timeout_sec=20) for client in clients)
        begun_s = time.monotonic()
        node.destroy_service(service)
        node.destroy_publisher(publisher)
        assert time.monotonic() - begun_s < 5.0
